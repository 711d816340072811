/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentMatrix.H"
#include "momentTensor.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentMatrix::momentMatrix(const ulphCloud& cloud)
:
    D_(cloud.D()),
    beta_(cloud.shared().beta)
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::momentMatrix::invertAll
(
    const ulph::geometryBlock& sums,
    ulph::laneRow* K
) const
{
    // Relative to beta, below which M holds noise only
    constexpr scalar poor = 1e-6;

    ulph::laneRow determinant;
    momentTensor::adjugate(D_, sums.count, sums.M, K, determinant);

    const scalar smallest = poor*std::pow(beta_, D_);
    for (int l = 0; l < sums.count; ++l)
    {
        if (determinant[l] > smallest)
        {
            const scalar factor = 1/determinant[l];
            for (int c = 0; c < ulph::nSymmetric(D_); ++c)
            {
                K[c][l] *= factor;
            }
        }
        else
        {
            momentTensor::setIsotropic(D_, l, 1/beta_, K);

            #pragma omp atomic
            ++nSingular_;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentMatrix::report(Ostream& os) const
{
    os  << "    momentMatrix: lattice matrix in place of a singular one "
        << returnReduce(nSingular_, sumOp<label>()) << " times" << nl;
}


// ************************************************************************* //
