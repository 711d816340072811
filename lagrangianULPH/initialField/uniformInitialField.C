/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "uniformInitialField.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::initialFields::uniform<Type>::uniform(const Type& value)
:
    value_(value)
{}


template<class Type>
Foam::initialFields::uniform<Type>::uniform
(
    const dictionary& dict,
    const initialRegion&
)
:
    value_(dict.get<Type>("value"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::initialFields::uniform<Type>::value
(
    const UList<point>& positions
) const
{
    return tmp<Field<Type>>::New(positions.size(), value_);
}


// ************************************************************************* //
