/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentTensor.H"

#include "symmetric.H"
#include "unroll.H"

#include <algorithm>
#include <type_traits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
using ulph::forEach;
using ulph::forEachComponent;
using ulph::symmetricIndex;

namespace
{

// Call f with the dimension as a compile-time constant: then the components of
// a lane are worked out together, in registers
template<class Function>
void byDimension(const int D, const Function& f)
{
    if (D == 2)
    {
        f(std::integral_constant<int, 2>());
    }
    else
    {
        f(std::integral_constant<int, 3>());
    }
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
        ulph::forLanes(count, [&](const int l)
        {
            adj[0][l] = M[2][l];
            adj[1][l] = -M[1][l];
            adj[2][l] = M[0][l];
            determinant[l] = M[0][l]*M[2][l] - M[1][l]*M[1][l];
        });
        return;
    }
    ulph::forLanes(count, [&](const int l)
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
    });
}


void Foam::momentTensor::leastMinor
(
    const int D,
    const int count,
    const ulph::laneRow* M,
    const scalar shift,
    ulph::laneRow& least
)
{
    if (D == 2)
    {
        ulph::forLanes(count, [&](const int l)
        {
            const double xx = M[0][l] - shift;
            const double yy = M[2][l] - shift;
            least[l] = std::min(xx, xx*yy - M[1][l]*M[1][l]);
        });
        return;
    }
    ulph::forLanes(count, [&](const int l)
    {
        const double xx = M[0][l] - shift;
        const double xy = M[1][l];
        const double xz = M[2][l];
        const double yy = M[3][l] - shift;
        const double yz = M[4][l];
        const double zz = M[5][l] - shift;
        const double second = xx*yy - xy*xy;
        const double third =
            zz*second - xx*yz*yz - yy*xz*xz + 2*xy*xz*yz;
        least[l] = std::min(xx, std::min(second, third));
    });
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
    byDimension(D, [&](const auto dimension)
    {
        constexpr int N = decltype(dimension)::value;
        ulph::forLanes(count, [&](const int l)
        {
            double row[N] = {};
            forEachComponent<N>([&](const auto i, const auto j) ULPH_INLINE
            {
                row[i] += K[symmetricIndex(N, i, j)][l]*a[j][l];
            });
            forEach<N>([&](const auto i) ULPH_INLINE { Ka[i][l] = row[i]; });
        });
    });
}


void Foam::momentTensor::addDot
(
    const int D,
    const int count,
    const scalar factor,
    const ulph::laneRow* a,
    const ulph::laneRow* b,
    ulph::laneRow& sum
)
{
    byDimension(D, [&](const auto dimension)
    {
        constexpr int N = decltype(dimension)::value;
        ulph::forLanes(count, [&](const int l)
        {
            double dot = 0;
            forEach<N>([&](const auto k) ULPH_INLINE { dot += a[k][l]*b[k][l]; });
            sum[l] += factor*dot;
        });
    });
}


void Foam::momentTensor::addContraction
(
    const int D,
    const int count,
    const scalar factor,
    const ulph::laneRow* K,
    const ulph::laneRow* L,
    ulph::laneRow& sum
)
{
    byDimension(D, [&](const auto dimension)
    {
        constexpr int N = decltype(dimension)::value;
        ulph::forLanes(count, [&](const int l)
        {
            double trace = 0;
            forEachComponent<N>([&](const auto i, const auto j) ULPH_INLINE
            {
                trace += K[symmetricIndex(N, i, j)][l]*L[i*N + j][l];
            });
            sum[l] += factor*trace;
        });
    });
}


void Foam::momentTensor::addSymmetricContraction
(
    const int D,
    const int count,
    const scalar factor,
    const ulph::laneRow* K,
    const ulph::laneRow* Q,
    ulph::laneRow& sum
)
{
    byDimension(D, [&](const auto dimension)
    {
        constexpr int N = decltype(dimension)::value;
        ulph::forLanes(count, [&](const int l)
        {
            double trace = 0;
            forEachComponent<N>([&](const auto i, const auto j) ULPH_INLINE
            {
                constexpr int c = symmetricIndex(N, i, j);
                trace += K[c][l]*Q[c][l];
            });
            sum[l] += factor*trace;
        });
    });
}


void Foam::momentTensor::divergence
(
    const int D,
    const int count,
    const ulph::laneRow* K,
    const ulph::laneRow* L,
    const ulph::laneRow& ahead,
    const scalar* W,
    ulph::laneRow& div
)
{
    byDimension(D, [&](const auto dimension)
    {
        constexpr int N = decltype(dimension)::value;
        ulph::forLanes(count, [&](const int l)
        {
            double G[N*N] = {};
            forEachComponent<N>([&](const auto i, const auto j) ULPH_INLINE
            {
                forEach<N>([&](const auto k) ULPH_INLINE
                {
                    G[i*N + j] += L[i*N + k][l]*K[symmetricIndex(N, k, j)][l];
                });
            });
            double trace = 0;
            double later = 0;
            forEach<N>([&](const auto i) ULPH_INLINE { trace += G[i*N + i]; });
            forEachComponent<N>([&](const auto i, const auto j) ULPH_INLINE
            {
                later += (G[i*N + j] + W[i*N + j])*G[j*N + i];
            });
            div[l] = trace + ahead[l]*later;
        });
    });
}


// ************************************************************************* //
