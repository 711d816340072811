/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "TaitEquationOfState.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace equationsOfState
{
    defineTypeNameAndDebug(TaitEquationOfState, 0);
    addToRunTimeSelectionTable(equationOfState, TaitEquationOfState, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::equationsOfState::TaitEquationOfState::TaitEquationOfState
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    rho0_(cloud.rho0()),
    gamma_
    (
        getInRange(dict, "gamma", 7, scalarMinMax::ge(SMALL))
    ),
    stiffness_(rho0_*sqr(cloud.c0())/gamma_)
{
    refuseMisspelt(dict, {"type", "gamma"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::equationsOfState::TaitEquationOfState::pressure
(
    const label count,
    const double* densityExcess,
    double* p
) const
{
    for (label l = 0; l < count; ++l)
    {
        p[l] =
            stiffness_
           *std::expm1(gamma_*std::log1p(densityExcess[l]/rho0_));
    }
}


void Foam::equationsOfState::TaitEquationOfState::densityExcess
(
    const label count,
    const double* p,
    double* densityExcess
) const
{
    for (label l = 0; l < count; ++l)
    {
        densityExcess[l] =
            rho0_*std::expm1(std::log1p(p[l]/stiffness_)/gamma_);
    }
}


Foam::scalar Foam::equationsOfState::TaitEquationOfState::energy
(
    const scalar densityExcess
) const
{
    const scalar log = std::log1p(densityExcess/rho0_);
    const scalar power = gamma_ - 1;
    const scalar work =
        mag(power) > SMALL ? std::expm1(power*log)/power : log;

    return stiffness_/rho0_*(work + std::expm1(-log));
}


// ************************************************************************* //
