/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ULPHDensityDiffusion.H"
#include "addToRunTimeSelectionTable.H"
#include "momentTensor.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace densityDiffusions
{
    defineTypeNameAndDebug(ULPHDensityDiffusion, 0);
    addToRunTimeSelectionTable(densityDiffusion, ULPHDensityDiffusion, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::densityDiffusions::ULPHDensityDiffusion::ULPHDensityDiffusion
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    laplacianDensityDiffusion(dict, cloud)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::effectNeeds Foam::densityDiffusions::ULPHDensityDiffusion::needs() const
{
    effectNeeds all(laplacianDensityDiffusion::needs());
    all.fields.set("densityGradient", D_);
    all.state.set("neighbourDiffusion", false);
    all.geometry |= ulph::gradientSums;
    all.force = ulph::densityDiffusionSums;
    return all;
}


void Foam::densityDiffusions::ULPHDensityDiffusion::addGradientRate
(
    const ulph::geometryBlock& sums,
    const ulph::laneRow* K,
    const ulph::laneRow* gradient,
    ulph::laneRow& rate
) const
{
    ulph::laneRow Kb[3];
    momentTensor::multiply(D_, sums.count, K, sums.b, Kb);
    momentTensor::addDot(D_, sums.count, -diffusivity_, gradient, Kb, rate);
}


void Foam::densityDiffusions::ULPHDensityDiffusion::addForceRate
(
    const ulph::forceBlock& sums,
    const ulph::laneRow* K,
    ulph::laneRow& rate
) const
{
    momentTensor::addContraction
    (
        D_, sums.count, -diffusivity_, K, sums.H, rate
    );
}


// ************************************************************************* //
