/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentTensor.H"

#include "symmetric.H"

#include <Eigen/Eigenvalues>
#include <algorithm>
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


// Closed forms lose half the digits where the two smallest eigenvalues of a
// 3 x 3 matrix meet, far from the isotropic matrix of the interior
double smallestOf3(const int lane, const ulph::laneRow* M)
{
    const double mean = (M[0][lane] + M[3][lane] + M[5][lane])/3;
    const double a = M[0][lane] - mean;
    const double b = M[3][lane] - mean;
    const double c = M[5][lane] - mean;
    const double d = M[1][lane];
    const double e = M[2][lane];
    const double f = M[4][lane];

    const double p2 = (a*a + b*b + c*c + 2*(d*d + e*e + f*f))/6;
    const double p = std::sqrt(p2);
    if (p < 1e-15*mean)
    {
        return mean;
    }
    const double determinant =
        a*(b*c - f*f) - d*(d*c - f*e) + e*(d*f - b*e);
    const double r =
        std::max(-1.0, std::min(1.0, determinant/(2*p2*p)));

    if (r > 0.999)
    {
        return Eigen::SelfAdjointEigenSolver<matrix<3>>
        (
            toEigen<3>(lane, M), Eigen::EigenvaluesOnly
        ).eigenvalues()[0];
    }
    constexpr double twoThirdsPi = 2.0943951023931954923;
    return mean + 2*p*std::cos(std::acos(r)/3 + twoThirdsPi);
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::momentTensor::adjugate
(
    const int D,
    const int count,
    const ulph::laneRow* M,
    ulph::laneRow* adj,
    ulph::laneRow& determinant
)
{
    if (D == 2)
    {
        for (int l = 0; l < count; ++l)
        {
            adj[0][l] = M[2][l];
            adj[1][l] = -M[1][l];
            adj[2][l] = M[0][l];
            determinant[l] = M[0][l]*M[2][l] - M[1][l]*M[1][l];
        }
        return;
    }
    for (int l = 0; l < count; ++l)
    {
        const double xx = M[0][l];
        const double xy = M[1][l];
        const double xz = M[2][l];
        const double yy = M[3][l];
        const double yz = M[4][l];
        const double zz = M[5][l];
        adj[0][l] = yy*zz - yz*yz;
        adj[1][l] = xz*yz - xy*zz;
        adj[2][l] = xy*yz - xz*yy;
        adj[3][l] = xx*zz - xz*xz;
        adj[4][l] = xy*xz - xx*yz;
        adj[5][l] = xx*yy - xy*xy;
        determinant[l] = xx*adj[0][l] + xy*adj[1][l] + xz*adj[2][l];
    }
}


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
        for (int l = 0; l < count; ++l)
        {
            const double mean = 0.5*(M[0][l] + M[2][l]);
            const double half = 0.5*(M[0][l] - M[2][l]);
            lambda[l] = mean - std::sqrt(half*half + M[1][l]*M[1][l]);
        }
        return;
    }
    for (int l = 0; l < count; ++l)
    {
        lambda[l] = smallestOf3(l, M);
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


void Foam::momentTensor::setIsotropic
(
    const int D,
    const int lane,
    const scalar value,
    ulph::laneRow* K
)
{
    for (int i = 0; i < D; ++i)
    {
        for (int j = i; j < D; ++j)
        {
            K[ulph::symmetricIndex(D, i, j)][lane] = i == j ? value : 0;
        }
    }
}


void Foam::momentTensor::multiply
(
    const int D,
    const int count,
    const ulph::laneRow* K,
    const ulph::laneRow* a,
    ulph::laneRow* Ka
)
{
    for (int i = 0; i < D; ++i)
    {
        for (int l = 0; l < count; ++l)
        {
            Ka[i][l] = 0;
        }
        for (int j = 0; j < D; ++j)
        {
            const int c = ulph::symmetricIndex(D, i, j);
            for (int l = 0; l < count; ++l)
            {
                Ka[i][l] += K[c][l]*a[j][l];
            }
        }
    }
}


// ************************************************************************* //
