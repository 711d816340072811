/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleLattice.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::particleLattice> Foam::particleLattice::New
(
    const dictionary& parent,
    const wallSearch& search,
    const scalar dx,
    const word& keyword
)
{
    // Not a copy: it would not know its parent
    const dictionary none;
    const dictionary& dict =
        parent.found(keyword) ? parent.subDict(keyword) : none;
    const word latticeType(dict.getOrDefault<word>("type", "cartesian"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(latticeType);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown particleLattice type " << latticeType << nl << nl
            << "Valid types are" << nl
            << dictionaryConstructorTablePtr_->sortedToc() << nl
            << exit(FatalIOError);
    }

    return autoPtr<particleLattice>(cstrIter()(dict, search, dx));
}


// ************************************************************************* //
