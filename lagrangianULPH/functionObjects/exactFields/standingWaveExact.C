/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "standingWaveExact.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "gravityForce.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace exactFields
{
    defineTypeNameAndDebug(standingWaveExact, 0);
    addToRunTimeSelectionTable(exactField, standingWaveExact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactFields::standingWaveExact::standingWaveExact
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    rho0_(cloud.rho0()),
    g_(bodyForces::gravityForce(dict, cloud).at(0).constant),
    A_(dict.get<scalar>("A")),
    k_(dict.get<scalar>("k")),
    H_(dict.get<scalar>("H")),
    nu_(dict.getOrDefault<scalar>("nu", 0)),
    origin_(dict.get<point>("origin")),
    direction_
    (
        normalised(dict.getOrDefault<vector>("direction", vector(1, 0, 0)))
    ),
    omega_(std::sqrt(mag(g_)*k_*std::tanh(k_*H_)))
{
    setTime(0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::exactFields::standingWaveExact::setTime(const scalar t)
{
    const scalar amplitude = A_*std::exp(-2*nu_*sqr(k_)*t);
    elevation_ = amplitude*std::cos(omega_*t);
    rise_ = -omega_*amplitude*std::sin(omega_*t);
}


Foam::vector Foam::exactFields::standingWaveExact::U(const point& x) const
{
    const vector up(-g_/mag(g_));
    const scalar phase = k_*((x - origin_) & direction_);
    const scalar kz = k_*(((x - origin_) & up) + H_);
    const scalar scale = rise_/std::sinh(k_*H_);
    return
        scale*std::sinh(kz)*std::cos(phase)*up
      - scale*std::cosh(kz)*std::sin(phase)*direction_;
}


Foam::scalar Foam::exactFields::standingWaveExact::p(const point& x) const
{
    const vector up(-g_/mag(g_));
    const scalar phase = k_*((x - origin_) & direction_);
    const scalar z = (x - origin_) & up;
    return
        rho0_*mag(g_)
       *(
            elevation_*std::cos(phase)
           *std::cosh(k_*(z + H_))/std::cosh(k_*H_)
          - z
        );
}


// ************************************************************************* //
