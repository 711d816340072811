/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "linearEquationOfState.H"
#include "addToRunTimeSelectionTable.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace equationsOfState
{
    defineTypeNameAndDebug(linearEquationOfState, 0);
    addToRunTimeSelectionTable(equationOfState, linearEquationOfState, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::equationsOfState::linearEquationOfState::linearEquationOfState
(
    const dictionary&,
    const ulphCloud& cloud
)
:
    rho0_(cloud.rho0()),
    c02_(sqr(cloud.c0()))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::equationsOfState::linearEquationOfState::pressure
(
    const label count,
    const double* densityExcess,
    double* p
) const
{
    ulph::forLanes(count, [&](const int l) { p[l] = c02_*densityExcess[l]; });
}


void Foam::equationsOfState::linearEquationOfState::densityExcess
(
    const label count,
    const double* p,
    double* densityExcess
) const
{
    for (label l = 0; l < count; ++l)
    {
        densityExcess[l] = p[l]/c02_;
    }
}


Foam::scalar Foam::equationsOfState::linearEquationOfState::energy
(
    const scalar densityExcess
) const
{
    const scalar s = densityExcess/rho0_;
    return c02_*(std::log1p(s) - s/(1 + s));
}


// ************************************************************************* //
