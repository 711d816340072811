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
    rates.geometry(middle, 0.5*dt);
    tools.advanceDensity(tools.densityLag() + 0.5*dt);
    tools.setDensityLag(0.5*dt);
    rates.force(middle, true);
    tools.kick(t, dt, rates.bodyForce(middle).perVelocity);
    tools.drift(middle, 0.5*dt);
    tools.shift(dt);
}


// ************************************************************************* //
