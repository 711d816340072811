/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "codedInitialField.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::initialFields::coded<Type>::coded
(
    const dictionary& dict,
    const initialRegion& region
)
:
    function_(dict),
    time_(region.time.value())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::initialFields::coded<Type>::value
(
    const UList<point>& positions
) const
{
    auto tvalues = tmp<Field<Type>>::New(positions.size());

    function_.evaluate
    (
        time_, positions.cdata(), tvalues.ref().data(), positions.size()
    );

    return tvalues;
}


// ************************************************************************* //
