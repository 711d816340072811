/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "initialField.H"
#include "uniformInitialField.H"
#include "ITstream.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

template<class Type>
Foam::autoPtr<Foam::initialField<Type>> Foam::initialField<Type>::New
(
    const word& entryName,
    const dictionary& regionDict,
    const initialRegion& region,
    const Type& deflt
)
{
    typedef initialFields::uniform<Type> uniformType;

    if (!regionDict.found(entryName))
    {
        return autoPtr<initialField<Type>>(new uniformType(deflt));
    }

    if (!regionDict.isDict(entryName))
    {
        ITstream& is = regionDict.lookup(entryName);
        const token first(is);

        // As in `uniform (1 0 0)` of OpenFOAM's fields
        if (!first.isWord() || first.wordToken() != uniformType::typeName)
        {
            is.putBack(first);
        }

        Type value;
        is >> value;

        return autoPtr<initialField<Type>>(new uniformType(value));
    }

    const dictionary& dict = regionDict.subDict(entryName);
    const word fieldType(dict.get<word>("type"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(fieldType);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown initialField type " << fieldType << " for "
            << entryName << nl << nl
            << "Valid types are" << nl
            << dictionaryConstructorTablePtr_->sortedToc() << nl
            << exit(FatalIOError);
    }

    return autoPtr<initialField<Type>>(cstrIter()(dict, region));
}


// ************************************************************************* //
