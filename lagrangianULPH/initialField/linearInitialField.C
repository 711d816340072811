/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "linearInitialField.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::initialFields::linear<Type>::linear
(
    const dictionary& dict,
    const initialRegion&
)
:
    value_(dict.getOrDefault<Type>("value", Zero)),
    origin_(dict.getOrDefault<point>("origin", Zero)),
    gradient_(dict.get<gradientType>("gradient"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::initialFields::linear<Type>::value
(
    const UList<point>& positions
) const
{
    auto tvalues = tmp<Field<Type>>::New(positions.size());

    forAll(positions, i)
    {
        tvalues.ref()[i] = value_ + ((positions[i] - origin_) & gradient_);
    }

    return tvalues;
}


// ************************************************************************* //
