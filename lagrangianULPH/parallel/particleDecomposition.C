/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleDecomposition.H"
#include "rankExchange.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::particleDecomposition::quantile
(
    const std::vector<point>& points,
    const direction axis,
    const scalar lower,
    const scalar upper,
    const scalar share
)
{
    // Of the extent: a hundredth of dx where there are 1e4 of them in a row
    constexpr int nRounds = 20;

    const scalar wanted = share*returnReduce(label(points.size()), sumOp<label>());
    scalar low = lower;
    scalar high = upper;
    for (int round = 0; round < nRounds; ++round)
    {
        const scalar middle = 0.5*(low + high);
        label below = 0;
        for (const point& p : points)
        {
            below += p[axis] < middle;
        }
        (returnReduce(below, sumOp<label>()) < wanted ? low : high) = middle;
    }
    return 0.5*(low + high);
}


void Foam::particleDecomposition::bisect
(
    const ulphCloud& cloud,
    const std::vector<point>& points,
    const label first,
    const label last
)
{
    if (last - first < 2)
    {
        return;
    }
    vector lower(vector::uniform(GREAT));
    vector upper(vector::uniform(-GREAT));
    for (const point& p : points)
    {
        lower = min(lower, p);
        upper = max(upper, p);
    }
    reduce(lower, minOp<vector>());
    reduce(upper, maxOp<vector>());

    const label middle = (first + last)/2;
    cut& now = cuts_[middle];
    now.axis = cloud.axis(0);
    for (int k = 1; k < cloud.D(); ++k)
    {
        const direction axis = cloud.axis(k);
        if (upper[axis] - lower[axis] > upper[now.axis] - lower[now.axis])
        {
            now.axis = axis;
        }
    }
    now.place = quantile
    (
        points, now.axis, lower[now.axis], upper[now.axis],
        scalar(middle - first)/(last - first)
    );

    std::vector<point> below;
    std::vector<point> above;
    for (const point& p : points)
    {
        (p[now.axis] < now.place ? below : above).push_back(p);
    }
    bisect(cloud, below, first, middle);
    bisect(cloud, above, middle, last);
}


bool Foam::particleDecomposition::isUneven(const ulphCloud& cloud) const
{
    constexpr scalar most = 1.1;

    return
        UPstream::nProcs()*scalar(returnReduce(cloud.size(), maxOp<label>()))
      > most*returnReduce(cloud.size(), sumOp<label>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleDecomposition::particleDecomposition()
:
    cuts_(UPstream::nProcs())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::particleDecomposition::rankOf(const point& p) const
{
    label first = 0;
    label last = label(cuts_.size());
    while (last - first > 1)
    {
        const label middle = (first + last)/2;
        const cut& now = cuts_[middle];
        (p[now.axis] < now.place ? last : first) = middle;
    }
    return first;
}


Foam::boundBox Foam::particleDecomposition::box(const label rank) const
{
    boundBox box(vector::uniform(-GREAT), vector::uniform(GREAT));
    label first = 0;
    label last = label(cuts_.size());
    while (last - first > 1)
    {
        const label middle = (first + last)/2;
        const cut& now = cuts_[middle];
        const bool below = rank < middle;
        (below ? box.max() : box.min())[now.axis] = now.place;
        (below ? last : first) = middle;
    }
    return box;
}


void Foam::particleDecomposition::distribute(ulphCloud& cloud)
{
    if (!UPstream::parRun())
    {
        return;
    }
    if (!isCut_ || isUneven(cloud))
    {
        isCut_ = true;
        std::vector<point> points(cloud.size());
        for (label i = 0; i < cloud.size(); ++i)
        {
            points[i] = cloud.position(i);
        }
        bisect(cloud, points, 0, UPstream::nProcs());
    }

    std::vector<std::vector<int>> leaving(UPstream::nProcs());
    std::vector<int> kept;
    for (label i = 0; i < cloud.size(); ++i)
    {
        const label rank = rankOf(cloud.position(i));
        (rank == UPstream::myProcNo() ? kept : leaving[rank]).push_back(i);
    }
    if (!returnReduce(label(kept.size()) < cloud.size(), orOp<bool>()))
    {
        return;
    }

    labelList sent(UPstream::nProcs());
    std::vector<int> inOrder;
    forAll(sent, rank)
    {
        sent[rank] = label(leaving[rank].size());
        inOrder.insert(inOrder.end(), leaving[rank].begin(), leaving[rank].end());
    }
    const rankExchange ways(sent);
    cloud.exchange
    (
        kept, ways.forth(cloud.stateOf(inOrder), cloud.valuesOfState())
    );
}


// ************************************************************************* //
