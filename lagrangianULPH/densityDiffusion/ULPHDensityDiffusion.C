/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ULPHDensityDiffusion.H"
#include "addToRunTimeSelectionTable.H"
#include "symmetric.H"

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
    for (int i = 0; i < D_; ++i)
    {
        for (int j = 0; j < D_; ++j)
        {
            const int c = ulph::symmetricIndex(D_, i, j);
            for (int l = 0; l < sums.count; ++l)
            {
                rate[l] -=
                    diffusivity_*gradient[i][l]*K[c][l]*sums.b[j][l];
            }
        }
    }
}


void Foam::densityDiffusions::ULPHDensityDiffusion::addForceRate
(
    const ulph::forceBlock& sums,
    const ulph::laneRow* K,
    ulph::laneRow& rate
) const
{
    for (int i = 0; i < D_; ++i)
    {
        for (int j = 0; j < D_; ++j)
        {
            const int c = ulph::symmetricIndex(D_, i, j);
            for (int l = 0; l < sums.count; ++l)
            {
                rate[l] -= diffusivity_*K[c][l]*sums.H[i*D_ + j][l];
            }
        }
    }
}


// ************************************************************************* //
