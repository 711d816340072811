/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "driftKickDrift.H"
#include "addToRunTimeSelectionTable.H"
#include "stepTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace timeIntegrations
{
    defineTypeNameAndDebug(driftKickDrift, 0);
    addToRunTimeSelectionTable(timeIntegration, driftKickDrift, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::timeIntegrations::driftKickDrift::driftKickDrift
(
    const dictionary&,
    const ulphCloud&
)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::timeIntegrations::driftKickDrift::advance
(
    stepTools& tools,
    const scalar t,
    const scalar dt
) const
{
    rightHandSide& rates = tools.rates();
    const scalar middle = t + 0.5*dt;

    tools.drift(t, 0.5*dt);
    tools.updateNeighbours();
    rates.geometry(middle, rightHandSide::laplacian::later);
    tools.advanceDensity(0.5*dt, 0);
    rates.force(middle, true);
    tools.kick(dt, rates.bodyForce(middle).perVelocity);
    rates.divergence();
    tools.advanceDensity(0.5*dt, dt);
    tools.drift(middle, 0.5*dt);
    tools.shift(dt);
}


// ************************************************************************* //
