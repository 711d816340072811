/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "profileInitialField.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::initialFields::profile<Type>::profile
(
    const dictionary& dict,
    const initialRegion&
)
:
    origin_(dict.getOrDefault<point>("origin", Zero)),
    direction_(normalised(dict.get<vector>("direction"))),
    value_(Function1<Type>::New("value", dict))
{
    if (magSqr(direction_) < 0.5)
    {
        FatalIOErrorInFunction(dict)
            << "The direction of a profile must not be zero"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::initialFields::profile<Type>::value
(
    const UList<point>& positions
) const
{
    auto tvalues = tmp<Field<Type>>::New(positions.size());

    forAll(positions, i)
    {
        tvalues.ref()[i] =
            value_->value((positions[i] - origin_) & direction_);
    }

    return tvalues;
}


// ************************************************************************* //
