/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "triangleTree.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

constexpr label maxLeafSize = 4;

//- Squared distance from a point to a box
inline scalar distanceSqr(const point& p, const point& min, const point& max)
{
    scalar sum = 0;

    for (direction d = 0; d < 3; ++d)
    {
        const scalar gap =
            std::max(std::max(min[d] - p[d], p[d] - max[d]), scalar(0));

        sum += gap*gap;
    }

    return sum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::triangleTree::build
(
    const label begin,
    const label end,
    const std::vector<point>& centres
)
{
    const label nodei = label(nodes_.size());
    nodes_.push_back
    (
        {
            point::uniform(VGREAT),
            point::uniform(-VGREAT),
            begin,
            end - begin
        }
    );

    point lo(point::uniform(VGREAT)), hi(point::uniform(-VGREAT));

    for (label i = begin; i < end; ++i)
    {
        for (const label pointi : triangles_[order_[i]])
        {
            nodes_[nodei].min = Foam::min(nodes_[nodei].min, points_[pointi]);
            nodes_[nodei].max = Foam::max(nodes_[nodei].max, points_[pointi]);
        }

        lo = Foam::min(lo, centres[order_[i]]);
        hi = Foam::max(hi, centres[order_[i]]);
    }

    if (end - begin <= maxLeafSize)
    {
        return;
    }

    const vector span(hi - lo);
    direction d = 0;
    if (span[1] > span[d]) d = 1;
    if (span[2] > span[d]) d = 2;

    const label middle = (begin + end)/2;

    std::nth_element
    (
        order_.begin() + begin,
        order_.begin() + middle,
        order_.begin() + end,
        [&](const label a, const label b)
        {
            return
                centres[a][d] < centres[b][d]
             || (centres[a][d] == centres[b][d] && a < b);
        }
    );

    nodes_[nodei].count = 0;
    build(begin, middle, centres);
    nodes_[nodei].first = label(nodes_.size());
    build(middle, end, centres);
}


void Foam::triangleTree::nearer
(
    const point& p,
    const label trianglei,
    hit& best
) const
{
    const triangle& t = triangles_[trianglei];
    const point& a = points_[t[0]];
    const point& b = points_[t[1]];
    const point& c = points_[t[2]];

    const auto take = [&](const point& q, const part on, const int which)
    {
        const scalar dSqr = magSqr(p - q);

        // Of equally near triangles the first, whatever the tree's shape
        if
        (
            dSqr < best.distanceSqr
         || (
                dSqr == best.distanceSqr
             && best.triangle >= 0
             && trianglei < best.triangle
            )
        )
        {
            best = {trianglei, q, dSqr, on, which};
        }
    };

    const vector ab(b - a), ac(c - a);

    const vector ap(p - a);
    const scalar d1 = ab & ap, d2 = ac & ap;
    if (d1 <= 0 && d2 <= 0) return take(a, part::vertex, 0);

    const vector bp(p - b);
    const scalar d3 = ab & bp, d4 = ac & bp;
    if (d3 >= 0 && d4 <= d3) return take(b, part::vertex, 1);

    const scalar vc = d1*d4 - d3*d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
    {
        return take(a + d1/(d1 - d3)*ab, part::edge, 0);
    }

    const vector cp(p - c);
    const scalar d5 = ab & cp, d6 = ac & cp;
    if (d6 >= 0 && d5 <= d6) return take(c, part::vertex, 2);

    const scalar vb = d5*d2 - d1*d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
    {
        return take(a + d2/(d2 - d6)*ac, part::edge, 2);
    }

    const scalar va = d3*d6 - d5*d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    {
        const scalar w = (d4 - d3)/((d4 - d3) + (d5 - d6));
        return take(b + w*(c - b), part::edge, 1);
    }

    const scalar sum = va + vb + vc;
    take(a + vb/sum*ab + vc/sum*ac, part::face, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::triangleTree::triangleTree
(
    const pointField& points,
    std::vector<triangle> triangles
)
:
    points_(points),
    triangles_(std::move(triangles))
{
    std::vector<point> centres;
    centres.reserve(triangles_.size());
    order_.reserve(triangles_.size());

    for (const triangle& t : triangles_)
    {
        order_.push_back(label(order_.size()));
        centres.push_back((points_[t[0]] + points_[t[1]] + points_[t[2]])/3);
    }

    if (triangles_.size())
    {
        build(0, size(), centres);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::triangleTree::hit Foam::triangleTree::nearest
(
    const point& p,
    const scalar maxDistanceSqr
) const
{
    hit best;
    best.distanceSqr = maxDistanceSqr;

    // A tree halved at every level is never deeper than the bits of a label
    std::array<std::pair<label, scalar>, 64> stack;
    int nStack = 0;

    if (nodes_.size())
    {
        stack[nStack++] = {0, distanceSqr(p, nodes_[0].min, nodes_[0].max)};
    }

    while (nStack)
    {
        const auto top = stack[--nStack];

        if (top.second > best.distanceSqr) continue;

        const node& n = nodes_[top.first];

        if (n.count)
        {
            for (label i = n.first; i < n.first + n.count; ++i)
            {
                nearer(p, order_[i], best);
            }
            continue;
        }

        const label left = top.first + 1, right = n.first;
        const scalar toLeft =
            distanceSqr(p, nodes_[left].min, nodes_[left].max);
        const scalar toRight =
            distanceSqr(p, nodes_[right].min, nodes_[right].max);

        // The nearer child is looked at first
        if (toLeft < toRight)
        {
            stack[nStack++] = {right, toRight};
            stack[nStack++] = {left, toLeft};
        }
        else
        {
            stack[nStack++] = {left, toLeft};
            stack[nStack++] = {right, toRight};
        }
    }

    return best;
}


std::vector<Foam::label> Foam::triangleTree::overlapping
(
    const boundBox& bb
) const
{
    std::vector<label> found, stack;

    if (nodes_.size())
    {
        stack.push_back(0);
    }

    while (stack.size())
    {
        const label nodei = stack.back();
        const node& n = nodes_[nodei];
        stack.pop_back();

        if (!bb.overlaps(boundBox(n.min, n.max))) continue;

        if (!n.count)
        {
            stack.push_back(nodei + 1);
            stack.push_back(n.first);
            continue;
        }

        for (label i = n.first; i < n.first + n.count; ++i)
        {
            const triangle& t = triangles_[order_[i]];
            const point& a = points_[t[0]];
            const point& b = points_[t[1]];
            const point& c = points_[t[2]];

            const boundBox own
            (
                Foam::min(a, Foam::min(b, c)),
                Foam::max(a, Foam::max(b, c))
            );

            if (bb.overlaps(own)) found.push_back(order_[i]);
        }
    }

    std::sort(found.begin(), found.end());

    return found;
}


// ************************************************************************* //
