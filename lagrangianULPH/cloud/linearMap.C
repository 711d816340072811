/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "linearMap.H"

#include "ulphCloud.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// vectors += A field; rows without a coefficient are not read
static void add
(
    const ulphCloud& cloud,
    const tensor& A,
    const particleField& field,
    const label first,
    const label count,
    ulph::laneRow* vectors
)
{
    if (A == tensor::zero)
    {
        return;
    }
    for (int m = 0; m < cloud.D(); ++m)
    {
        ulph::laneRow row;
        bool loaded = false;
        for (int k = 0; k < cloud.D(); ++k)
        {
            const scalar a = A(cloud.axis(k), cloud.axis(m));
            if (a == 0)
            {
                continue;
            }
            if (!loaded)
            {
                field.load(m, first, count, row);
                loaded = true;
            }
            ulph::laneRow& sum = vectors[k];
            ulph::forLanes(count, [&](const int l) { sum[l] += a*row[l]; });
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::linearMap::rows
(
    const ulphCloud& cloud,
    const particleField& x,
    const particleField* v,
    const label first,
    const label count,
    ulph::laneRow* vectors
) const
{
    for (int k = 0; k < cloud.D(); ++k)
    {
        ulph::laneRow& row = vectors[k];
        const scalar c = constant[cloud.axis(k)];
        ulph::forLanes(count, [&](const int l) { row[l] = c; });
    }
    add(cloud, perLength, x, first, count, vectors);
    if (v)
    {
        add(cloud, perVelocity, *v, first, count, vectors);
    }
}


// ************************************************************************* //
