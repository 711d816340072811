/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "laplacianDensityDiffusion.H"
#include "addToRunTimeSelectionTable.H"
#include "momentTensor.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace densityDiffusions
{
    defineTypeNameAndDebug(laplacianDensityDiffusion, 0);
    addToRunTimeSelectionTable(densityDiffusion, laplacianDensityDiffusion, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::densityDiffusions::laplacianDensityDiffusion::laplacianDensityDiffusion
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    D_(cloud.D()),
    diffusivity_
    (
        getInRange(dict, "delta", 0.1, scalarMinMax::ge(0))
       *cloud.h()*cloud.c0()
    )
{
    refuseMisspelt(dict, {"type", "delta"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::effectNeeds Foam::densityDiffusions::laplacianDensityDiffusion::needs() const
{
    effectNeeds all;
    all.fields.set("densityDiffusion", 1);
    all.geometry = ulph::laplacianSums;
    return all;
}


void Foam::densityDiffusions::laplacianDensityDiffusion::addLaplacianRate
(
    const ulph::geometryBlock& sums,
    const ulph::laneRow* K,
    ulph::laneRow& rate
) const
{
    momentTensor::addSymmetricContraction
    (
        D_, sums.count, 2*diffusivity_, K, sums.Q, rate
    );
}


// ************************************************************************* //
