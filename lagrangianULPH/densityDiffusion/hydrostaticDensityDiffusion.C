/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hydrostaticDensityDiffusion.H"
#include "addToRunTimeSelectionTable.H"
#include "symmetric.H"

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
    for (int i = 0; i < D_; ++i)
    {
        for (int j = 0; j < D_; ++j)
        {
            const int c = ulph::symmetricIndex(D_, i, j);
            for (int l = 0; l < sums.count; ++l)
            {
                rate[l] -=
                    2*diffusivity_*gradient[i][l]*K[c][l]*sums.b[j][l];
            }
        }
    }
}


// ************************************************************************* //
