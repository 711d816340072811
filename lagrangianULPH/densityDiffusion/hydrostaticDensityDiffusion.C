/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hydrostaticDensityDiffusion.H"
#include "addToRunTimeSelectionTable.H"
#include "momentTensor.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace densityDiffusions
{
    defineTypeNameAndDebug(hydrostaticDensityDiffusion, 0);
    addToRunTimeSelectionTable(densityDiffusion, hydrostaticDensityDiffusion, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::densityDiffusions::hydrostaticDensityDiffusion::hydrostaticDensityDiffusion
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    laplacianDensityDiffusion(dict, cloud)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::densityDiffusions::hydrostaticDensityDiffusion::addGradientRate
(
    const ulph::geometryBlock& sums,
    const ulph::laneRow* K,
    const ulph::laneRow* gradient,
    ulph::laneRow& rate
) const
{
    ulph::laneRow Kb[3];
    momentTensor::multiply(D_, sums.count, K, sums.b, Kb);
    momentTensor::addDot(D_, sums.count, -2*diffusivity_, gradient, Kb, rate);
}


// ************************************************************************* //
