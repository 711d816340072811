/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rotatingRectangleInitialField.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace initialFields
{
    defineTypeNameAndDebug(rotatingRectangle, 0);
}

    initialField<scalar>::adddictionaryConstructorToTable
        <initialFields::rotatingRectangle>
        addrotatingRectangleInitialFieldToTable_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::initialFields::rotatingRectangle::rotatingRectangle
(
    const dictionary& dict,
    const initialRegion&
)
:
    rho0_(dict.get<scalar>("rho0", keyType::REGEX_RECURSIVE)),
    omega_(dict.get<scalar>("omega")),
    half_(0.5*dict.get<vector2D>("sides")),
    centre_(dict.getOrDefault<point>("centre", Zero))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::initialFields::rotatingRectangle::value
(
    const UList<point>& positions
) const
{
    // The rest of the sum is below 1e-6 rho0 omega^2 a^2
    constexpr label terms = 400;

    const scalar a = half_.x();
    const scalar b = half_.y();

    auto tvalues = tmp<scalarField>::New(positions.size());
    forAll(positions, i)
    {
        const scalar x = positions[i].x() - centre_.x();
        const scalar y = mag(positions[i].y() - centre_.y());

        scalar sum = sqr(x) - sqr(a);
        for (label n = 1; n < 2*terms; n += 2)
        {
            const scalar k = n*constant::mathematical::piByTwo/a;
            const scalar ratio =
                std::exp(k*(y - b))*(1 + std::exp(-2*k*y))
               /(1 + std::exp(-2*k*b));

            sum += (n % 4 == 1 ? 4 : -4)/(a*pow3(k))*std::cos(k*x)*ratio;
        }
        tvalues.ref()[i] = rho0_*sqr(omega_)*sum;
    }
    return tvalues;
}


// ************************************************************************* //
