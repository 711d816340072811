/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "predictorCorrector.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"
#include "stepTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace timeIntegrations
{
    defineTypeNameAndDebug(predictorCorrector, 0);
    addToRunTimeSelectionTable(timeIntegration, predictorCorrector, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::timeIntegrations::predictorCorrector::predictorCorrector
(
    const dictionary& dict,
    const ulphCloud&
)
:
    frozenGeometry_(dict.getOrDefault("frozenGeometry", true))
{
    refuseMisspelt(dict, {"type", "frozenGeometry"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::timeIntegrations::predictorCorrector::advance
(
    stepTools& tools,
    const scalar t,
    const scalar dt
) const
{
    rightHandSide& rates = tools.rates();

    tools.updateNeighbours(t);
    rates.geometry(t);
    rates.findSurface();
    rates.force(t, t + 0.5*dt, false);

    tools.drift(t, 0.5*dt, t);
    tools.save(0.5*dt);
    tools.kick(t, 0.5*dt);
    tools.advanceDensity(0, 0.5*dt);

    const bool reordered = tools.updateNeighbours(t + 0.5*dt);
    if (frozenGeometry_ && !reordered)
    {
        rates.frozenForce(t + 0.5*dt, t, t + dt);
    }
    else
    {
        rates.geometry(t + 0.5*dt);
        if (reordered)
        {
            rates.findSurface();
        }
        rates.force(t, t + dt, false);
    }

    tools.advanceSaved(t, dt);
    tools.shift(t + dt, dt);
    tools.setDensityLag(0);
}


// ************************************************************************* //
