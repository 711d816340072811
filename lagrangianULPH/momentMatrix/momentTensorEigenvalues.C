/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentTensor.H"

#include "symmetric.H"

#include <Eigen/Eigenvalues>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

template<int D>
using matrix = Eigen::Matrix<double, D, D>;

template<int D>
matrix<D> toEigen(const int lane, const ulph::laneRow* M)
{
    matrix<D> A;
    for (int i = 0; i < D; ++i)
    {
        for (int j = 0; j < D; ++j)
        {
            A(i, j) = M[ulph::symmetricIndex(D, i, j)][lane];
        }
    }
    return A;
}


template<int D>
void floored
(
    const int lane,
    const ulph::laneRow* M,
    const double floor,
    ulph::laneRow* K
)
{
    const Eigen::SelfAdjointEigenSolver<matrix<D>> eigen(toEigen<D>(lane, M));
    const matrix<D> inverse =
        eigen.eigenvectors()
       *eigen.eigenvalues().cwiseMax(floor).cwiseInverse().asDiagonal()
       *eigen.eigenvectors().transpose();

    for (int i = 0; i < D; ++i)
    {
        for (int j = i; j < D; ++j)
        {
            K[ulph::symmetricIndex(D, i, j)][lane] = inverse(i, j);
        }
    }
}


// Smallest eigenvalues of a few lanes by the trigonometric solution
//     lambda = mean - 2 p cos(acos(-r)/3),
// whose cosine c solves 4 c^3 - 3 c = -r in [1/2, 1]: Newton steps from a guess
// with the right root at r = 1 take that to rounding. Returns r.
template<class Lanes>
Lanes smallestOf3(const int lane, const ulph::laneRow* M, Lanes& lambda)
{
    const auto row = [&](const int c)
    {
        return Lanes(M[c] + lane, ulph::stdx::element_aligned);
    };
    const Lanes mean = (row(0) + row(3) + row(5))/3;
    const Lanes a = row(0) - mean;
    const Lanes b = row(3) - mean;
    const Lanes c = row(5) - mean;
    const Lanes d = row(1);
    const Lanes e = row(2);
    const Lanes f = row(4);

    const Lanes p2 =
        max((a*a + b*b + c*c + 2*(d*d + e*e + f*f))/6, Lanes(VSMALL));
    const Lanes p = sqrt(p2);
    const Lanes determinant =
        a*(b*c - f*f) - d*(d*c - f*e) + e*(d*f - b*e);
    const Lanes r =
        max(Lanes(-1), min(Lanes(1), determinant/(2*p2*p)));

    Lanes cosine = 0.5*(1 + sqrt(max(0.5*(1 - r), Lanes(1e-16))));
    for (int step = 0; step < 5; ++step)
    {
        const Lanes square = cosine*cosine;
        cosine -= (cosine*(4*square - 3) + r)/(12*square - 3);
    }
    lambda = mean - 2*p*cosine;
    return r;
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::momentTensor::smallestEigenvalue
(
    const int D,
    const int count,
    const ulph::laneRow* M,
    ulph::laneRow& lambda
)
{
    if (D == 2)
    {
        ulph::forLanes(count, [&](const int l)
        {
            const double mean = 0.5*(M[0][l] + M[2][l]);
            const double half = 0.5*(M[0][l] - M[2][l]);
            lambda[l] = mean - std::sqrt(half*half + M[1][l]*M[1][l]);
        });
        return;
    }

    // All lanes: what is in those beyond count does not matter
    using lanes = ulph::stdx::native_simd<double>;
    for (int first = 0; first < count; first += int(lanes::size()))
    {
        lanes smallest;
        const lanes r = smallestOf3(first, M, smallest);
        for (int l = first; l < min(count, first + int(lanes::size())); ++l)
        {
            // Closed forms lose half the digits where the two smallest meet
            lambda[l] =
                r[l - first] < 1 - 1e-6
              ? double(smallest[l - first])
              : Eigen::SelfAdjointEigenSolver<matrix<3>>
                (
                    toEigen<3>(l, M), Eigen::EigenvaluesOnly
                ).eigenvalues()[0];
        }
    }
}


void Foam::momentTensor::flooredInverse
(
    const int D,
    const int lane,
    const ulph::laneRow* M,
    const scalar floor,
    ulph::laneRow* K
)
{
    D == 2 ? floored<2>(lane, M, floor, K) : floored<3>(lane, M, floor, K);
}


// ************************************************************************* //
