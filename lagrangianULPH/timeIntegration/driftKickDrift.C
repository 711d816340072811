/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "driftKickDrift.H"
#include "addToRunTimeSelectionTable.H"
#include "stepTools.H"
#include "wallPolyPatch.H"
#include "fvMesh.H"

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
    const ulphCloud& cloud
)
:
    walls_(cloud.mesh().boundaryMesh().findPatchIDs<wallPolyPatch>().size())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::effectNeeds Foam::timeIntegrations::driftKickDrift::needs() const
{
    effectNeeds all;
    if (walls_)
    {
        all.state.set("divergenceAfterKick", true);
    }
    return all;
}


void Foam::timeIntegrations::driftKickDrift::advance
(
    stepTools& tools,
    const scalar t,
    const scalar dt
) const
{
    rightHandSide& rates = tools.rates();
    const scalar half = 0.5*dt;

    tools.drift(t, half, t);
    tools.updateNeighbours(t + half);
    rates.geometry(t + half, half);
    rates.findSurface();
    tools.advanceDensity(tools.densityLag(), half);
    tools.setDensityLag(half);
    rates.force(t, t + dt, true);
    tools.kick(t, dt, rates.bodyForce(t, t + dt).perVelocity);
    rates.divergence(t + half, half);
    tools.drift(t + half, half, t + dt);
    tools.shift(t + dt, dt);
}


// ************************************************************************* //
