/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "optimalMomentMatrix.H"
#include "addToRunTimeSelectionTable.H"
#include "freeSurface.H"
#include "momentTensor.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace momentMatrices
{
    defineTypeNameAndDebug(optimalMomentMatrix, 0);
    addToRunTimeSelectionTable(momentMatrix, optimalMomentMatrix, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentMatrices::optimalMomentMatrix::optimalMomentMatrix
(
    const dictionary&,
    const ulphCloud& cloud
)
:
    momentMatrix(cloud)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentMatrices::optimalMomentMatrix::invert
(
    const ulph::geometryBlock& sums,
    const ulph::laneRow& surface,
    ulph::laneRow* K
)
{
    // Below this part of beta a diagonal entry holds noise only
    constexpr scalar poor = 1e-6;

    invertAll(sums, K);

    for (int l = 0; l < sums.count; ++l)
    {
        if (surface[l] == freeSurface::interior)
        {
            continue;
        }
        momentTensor::setIsotropic(D_, l, 1/beta_, K);
        for (int i = 0; i < D_; ++i)
        {
            const int c = ulph::symmetricIndex(D_, i, i);
            if (sums.M[c][l] > poor*beta_)
            {
                K[c][l] = 1/sums.M[c][l];
            }
        }
    }
}


// ************************************************************************* //
