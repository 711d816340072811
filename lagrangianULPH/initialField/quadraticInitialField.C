/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "quadraticInitialField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace initialFields
{
    defineTypeNameAndDebug(quadratic, 0);
}

    initialField<scalar>::adddictionaryConstructorToTable
        <initialFields::quadratic> addquadraticInitialFieldToTable_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::initialFields::quadratic::quadratic
(
    const dictionary& dict,
    const initialRegion&
)
:
    value_(dict.get<scalar>("value")),
    origin_(dict.getOrDefault<point>("origin", Zero)),
    gradient_(dict.getOrDefault<vector>("gradient", Zero)),
    hessian_(dict.get<symmTensor>("hessian"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::initialFields::quadratic::value
(
    const UList<point>& positions
) const
{
    auto tvalues = tmp<scalarField>::New(positions.size());
    forAll(positions, i)
    {
        const vector d(positions[i] - origin_);
        tvalues.ref()[i] = value_ + (d & (gradient_ + 0.5*(hessian_ & d)));
    }
    return tvalues;
}


// ************************************************************************* //
