/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eigenvalueFlooredMomentMatrix.H"
#include "addToRunTimeSelectionTable.H"
#include "momentTensor.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace momentMatrices
{
    defineTypeNameAndDebug(eigenvalueFlooredMomentMatrix, 0);
    addToRunTimeSelectionTable(momentMatrix, eigenvalueFlooredMomentMatrix, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentMatrices::eigenvalueFlooredMomentMatrix::eigenvalueFlooredMomentMatrix
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    momentMatrix(cloud),
    floor_
    (
        beta_*getInRange
        (
            dict, "floor", 0.5, scalarMinMax(SMALL, 1)
        )
    )
{
    refuseMisspelt(dict, {"type", "floor"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentMatrices::eigenvalueFlooredMomentMatrix::invert
(
    const ulph::geometryBlock& sums,
    const ulph::laneRow&,
    ulph::laneRow* K
)
{
    ulph::laneRow determinant;
    ulph::laneRow minor;
    momentTensor::adjugate(D_, sums.count, sums.M, K, determinant);
    momentTensor::leastMinor(D_, sums.count, sums.M, floor_, minor);

    ulph::forLanes(sums.count, [&](const int l)
    {
        determinant[l] = 1/max(determinant[l], VSMALL);
    });
    for (int c = 0; c < ulph::nSymmetric(D_); ++c)
    {
        ulph::forLanes(sums.count, [&](const int l)
        {
            K[c][l] *= determinant[l];
        });
    }

    label nFloored = 0;
    for (int l = 0; l < sums.count; ++l)
    {
        if (!(minor[l] > 0))
        {
            momentTensor::flooredInverse(D_, l, sums.M, floor_, K);
            ++nFloored;
        }
    }
    if (nFloored)
    {
        #pragma omp atomic
        nFloored_ += nFloored;
    }
}


void Foam::momentMatrices::eigenvalueFlooredMomentMatrix::report(Ostream& os) const
{
    os  << "    momentMatrix: an eigenvalue floored "
        << returnReduce(nFloored_, sumOp<label>()) << " times" << nl;
}


// ************************************************************************* //
