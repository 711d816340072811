// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

#include "clusterList.H"
#include "indexList.H"
#include "orderedSet.H"
#include "simd.H"

#include <algorithm>
#include <limits>
#include <omp.h>

namespace ulph
{

namespace
{

struct box
{
    std::array<double, 3> lower{};
    std::array<double, 3> upper{};
};

box boundingBox(const particleView& p, const int first, const int count)
{
    box b;
    for (int k = 0; k < p.D; ++k)
    {
        const auto range =
            std::minmax_element(p.x[k] + first, p.x[k] + first + count);
        b.lower[k] = *range.first;
        b.upper[k] = *range.second;
    }
    return b;
}

// Members of a cluster in lanes, relative to the centre of their box so that
// float will do
class memberLanes
{
    using lane = lanes<float>::real;

    static constexpr int width = int(lane::size());

    const int D_;
    const int nRows_;
    std::array<double, 3> centre_{};
    lane x_[3][(maxLanes + width - 1)/width];

public:

    memberLanes
    (
        const particleView& p,
        const box& b,
        const int first,
        const int count
    )
    :
        D_(p.D),
        nRows_((count + width - 1)/width)
    {
        for (int k = 0; k < D_; ++k)
        {
            centre_[k] = 0.5*(b.lower[k] + b.upper[k]);
            for (int r = 0; r < nRows_; ++r)
            {
                for (int l = 0; l < width; ++l)
                {
                    const int m = std::min(r*width + l, count - 1);
                    x_[k][r][l] = float(p.x[k][first + m] - centre_[k]);
                }
            }
        }
    }

    //- Is a source closer to any member than the root of reach2?
    template<int D>
    bool reached(const particleView& p, const int j, const float reach2) const
    {
        float x[D];
        for (int k = 0; k < D; ++k)
        {
            x[k] = float(p.x[k][j] - centre_[k]);
        }
        // No way out between the rows: it would be guessed wrong too often
        lane nearest = std::numeric_limits<float>::max();
        for (int r = 0; r < nRows_; ++r)
        {
            lane d2 = 0;
            for (int k = 0; k < D; ++k)
            {
                const lane d = x_[k][r] - x[k];
                d2 += d*d;
            }
            nearest = min(nearest, d2);
        }
        return any_of(nearest < reach2);
    }
};

// Squared distance of the cells along direction k from the box
void cellDistances
(
    const cellLayout& cells,
    const box& b,
    const int k,
    const int lower,
    const int upper,
    std::vector<double>& d2
)
{
    d2.clear();
    for (int c = lower; c <= upper; ++c)
    {
        const double left = cells.lower()[k] + c*cells.size();
        const double right = left + cells.size();
        // What lies beyond the grid is kept in its outermost cells
        const double d = std::max
        (
            c == cells.extent(k) - 1 ? 0 : b.lower[k] - right,
            c == 0 ? 0 : left - b.upper[k]
        );
        d2.push_back(d > 0 ? d*d : 0);
    }
}

// Room for as much again per cluster as so far, once there is something to judge
// by: doubling, as vectors do, would waste a quarter of the largest array on
// average
void makeRoom
(
    std::vector<clusterList::sources::step>& steps,
    const int nDone,
    const int nClusters
)
{
    const std::size_t size = steps.size();
    if (16*nDone < nClusters || steps.capacity() - size > size/64)
    {
        return;
    }
    const std::size_t expected = std::size_t(double(size)*nClusters/nDone);
    if (expected > steps.capacity())
    {
        steps.reserve(std::max(expected + expected/64, size + size/32));
    }
}

// Places along the curve of the cells with particles nearer than reach to a box
template<int D>
void findCells
(
    const cellGrid& grid,
    const box& b,
    const double reach,
    orderedSet& found
)
{
    const cellLayout& cells = grid.layout();
    thread_local std::vector<double> d2[3];
    std::array<int, 3> lower{0, 0, 0};
    for (int k = 0; k < D; ++k)
    {
        lower[k] = cells.coordinate(k, b.lower[k] - reach);
        cellDistances
        (
            cells, b, k, lower[k], cells.coordinate(k, b.upper[k] + reach), d2[k]
        );
    }
    if (D == 2)
    {
        d2[2].assign(1, 0);
    }

    found.resize(cells.nCells());
    for (std::size_t k = 0; k < d2[2].size(); ++k)
    {
        for (std::size_t j = 0; j < d2[1].size(); ++j)
        {
            for (std::size_t i = 0; i < d2[0].size(); ++i)
            {
                const int r = cells.rank
                (
                    lower[0] + int(i), lower[1] + int(j), lower[2] + int(k)
                );
                if
                (
                    d2[0][i] + d2[1][j] + d2[2][k] < reach*reach
                 && grid.first(r) < grid.first(r + 1)
                )
                {
                    found.insert(r);
                }
            }
        }
    }
}

// Append the sources of a group closer to a member than reach, in order
template<int D>
void listSources
(
    const clusterList::sourceGroup& group,
    const box& b,
    const memberLanes& members,
    const double reach,
    indexList& listed
)
{
    if (!group.grid || group.particles.n == 0)
    {
        return;
    }
    // Rounding of float must not lose a pair
    const float safeReach2 = float(reach*reach*(1 + 1e-5));

    thread_local orderedSet cells;
    findCells<D>(*group.grid, b, reach, cells);
    cells.drain([&](const int r)
    {
        const int first = group.grid->first(r);
        listed.appendIf
        (
            group.offset + first,
            group.grid->first(r + 1) - first,
            [&](const int i)
            {
                return members.reached<D>(group.particles, first + i, safeReach2);
            }
        );
    });
}

// Consecutive targets of [first, last) as clusters of up to width
void formBlock
(
    const clusterList::sourceGroup& targets,
    int first,
    const int last,
    const int width,
    const double longest,
    std::vector<clusterList::cluster>& clusters
)
{
    const particleView& p = targets.particles;
    while (first < last)
    {
        box b = boundingBox(p, first, 1);
        int count = 1;
        for (; count < width && first + count < last; ++count)
        {
            const int i = first + count;
            box grown = b;
            bool fits = true;
            for (int k = 0; k < p.D; ++k)
            {
                grown.lower[k] = std::min(b.lower[k], p.x[k][i]);
                grown.upper[k] = std::max(b.upper[k], p.x[k][i]);
                fits = fits && grown.upper[k] - grown.lower[k] <= longest;
            }
            if (!fits)
            {
                break;
            }
            b = grown;
        }
        clusters.push_back({targets.offset + first, count, 0, 0, 0, 0, 0, 0});
        first += count;
    }
}

} // End anonymous namespace

void clusterList::formClusters
(
    const sourceGroup& targets,
    const int width,
    const double longest
)
{
    // Clusters do not reach across blocks, however many threads form them
    constexpr int blockSize = 64*maxLanes;
    const int n = targets.particles.n;
    const int nBlocks = (n + blockSize - 1)/blockSize;

    std::vector<std::vector<cluster>> formed(nBlocks);
    #pragma omp parallel for schedule(static)
    for (int i = 0; i < nBlocks; ++i)
    {
        const int first = i*blockSize;
        formed[i].reserve(blockSize/width);
        formBlock
        (
            targets, first, std::min(first + blockSize, n), width, longest,
            formed[i]
        );
    }

    clusters_.clear();
    clusters_.reserve(n/width + nBlocks);
    for (const std::vector<cluster>& block : formed)
    {
        clusters_.insert(clusters_.end(), block.begin(), block.end());
    }
}

void clusterList::build
(
    const sourceGroup& targets,
    const int width,
    const double reach,
    const double longest,
    const sourceGroups& groups
)
{
    formClusters(targets, width, longest);

    // A few per thread: some clusters have more to search than others
    const int nParts = 8*omp_get_max_threads();
    const int nClusters = size();
    parts_.resize(nParts);

    #pragma omp parallel for schedule(dynamic, 1)
    for (int t = 0; t < nParts; ++t)
    {
        // Taken out: the heads of the parts lie side by side in one cache line
        std::vector<sources::step> part(std::move(parts_[t]));
        part.clear();
        indexList listed;
        const int start = int(std::int64_t(nClusters)*t/nParts);
        const int last = int(std::int64_t(nClusters)*(t + 1)/nParts);
        for (int c = start; c < last; ++c)
        {
            makeRoom(part, c - start, last - start);
            cluster& now = clusters_[c];
            now.part = t;
            const int first = now.first - targets.offset;
            const box b = boundingBox(targets.particles, first, now.count);
            const memberLanes members(targets.particles, b, first, now.count);
            const auto list = [&](const sourceGroup& group)
            {
                targets.particles.D == 2
              ? listSources<2>(group, b, members, reach, listed)
              : listSources<3>(group, b, members, reach, listed);
            };
            now.begin = part.size();
            listed.clear();
            list(groups.fluid);
            list(groups.halo);
            now.fluid = listed.appendTo(part);
            now.fluidEnd = part.size();
            listed.clear();
            list(groups.wall);
            now.wall = listed.appendTo(part);
            now.end = part.size();
        }
        parts_[t] = std::move(part);
    }

    nPairs_ = 0;
    nTargets_ = targets.particles.n;
    for (const cluster& c : clusters_)
    {
        nPairs_ += double(c.end - c.begin)*c.count;
    }
}

std::size_t clusterList::bytes() const
{
    std::size_t n = sizeof(cluster)*clusters_.capacity();
    for (const auto& part : parts_)
    {
        n += sizeof(sources::step)*part.capacity();
    }
    return n;
}

} // End namespace ulph
