// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

#include "clusterList.H"
#include "indexList.H"
#include "simd.H"

#include <algorithm>
#include <limits>
#include <numeric>
#include <omp.h>

namespace ulph
{

namespace
{

// Members of a cluster, relative to the centre of their box so that float will do
class clusterMembers
{
    using lane = lanes<float>::real;

    static constexpr int width = int(lane::size());

    const int count_;
    std::array<double, 3> centre_{};
    lane x_[maxLanes][3];

    //- Coordinates of sources from the first on; beyond count some of those before
    lane load(const particleView& p, const int k, const int first, const int count)
        const
    {
        alignas(64) float x[width];
        const double* const from = p.x[k] + first;
        if (first + width <= p.n)
        {
            for (int l = 0; l < width; ++l)
            {
                x[l] = float(from[l] - centre_[k]);
            }
        }
        else
        {
            for (int l = 0; l < width; ++l)
            {
                x[l] = float(from[std::min(l, count - 1)] - centre_[k]);
            }
        }
        return lane(x, stdx::vector_aligned);
    }

public:

    clusterMembers
    (
        const particleView& p,
        const particleBox& b,
        const int first,
        const int count
    )
    :
        count_(count)
    {
        for (int k = 0; k < p.D; ++k)
        {
            centre_[k] = b.centre(k);
            for (int m = 0; m < count; ++m)
            {
                x_[m][k] = float(p.x[k][first + m] - centre_[k]);
            }
        }
    }

    //- Append those of count sources from the first on that are closer to any member
    //- than the root of reach2
    template<int D>
    void appendReached
    (
        const particleView& p,
        const int offset,
        int first,
        const int last,
        const float reach2,
        indexList& listed
    ) const
    {
        for (; first < last; first += width)
        {
            const int count = std::min(width, last - first);
            lane x[D];
            for (int k = 0; k < D; ++k)
            {
                x[k] = load(p, k, first, count);
            }
            lane nearest = std::numeric_limits<float>::max();
            for (int m = 0; m < count_; ++m)
            {
                lane d2 = 0;
                for (int k = 0; k < D; ++k)
                {
                    const lane d = x[k] - x_[m][k];
                    d2 += d*d;
                }
                nearest = min(nearest, d2);
            }
            listed.appendSet
            (
                offset + first, lanesSet(nearest < reach2) & ((1u << count) - 1)
            );
        }
    }
};

// Room for as much again per cluster as so far, once there is something to judge
// by: doubling, as vectors do, would waste a quarter of the largest array on
// average
void makeRoom
(
    unsetVector<clusterList::sources::step>& steps,
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

// Append the sources of a group closer to a member than reach, in order
template<int D>
void listSources
(
    const clusterList::sourceGroup& group,
    const particleBox& box,
    const clusterMembers& members,
    const double reach,
    indexList& listed
)
{
    if (!group.clusters)
    {
        return;
    }
    // Rounding of float must not lose a pair
    const float safeReach2 = float(reach*reach*(1 + 1e-5));

    group.clusters->forEachNear<D>
    (
        box,
        reach,
        [&](const int c)
        {
            const int first = group.clusters->first(c);
            members.appendReached<D>
            (
                group.particles,
                group.offset,
                first,
                first + group.clusters->count(c),
                safeReach2,
                listed
            );
        }
    );
}

} // End anonymous namespace

void clusterList::list
(
    const std::vector<int>& which,
    const int firstPart,
    const sourceGroup& targets,
    const double reach,
    const sourceGroups& groups
)
{
    const int nParts = int(parts_.size())/2;
    const std::int64_t n = std::int64_t(which.size());

    #pragma omp parallel for schedule(dynamic, 1)
    for (int t = 0; t < nParts; ++t)
    {
        // Taken out: the heads of the parts lie side by side in one cache line
        unsetVector<sources::step> part(std::move(parts_[firstPart + t]));
        part.clear();
        indexList listed;
        const int start = int(n*t/nParts);
        const int last = int(n*(t + 1)/nParts);
        for (int i = start; i < last; ++i)
        {
            makeRoom(part, i - start, last - start);
            cluster& now = clusters_[which[i]];
            now.part = firstPart + t;
            const int first = now.first - targets.offset;
            const particleBox box(targets.particles, first, now.count);
            const clusterMembers members(targets.particles, box, first, now.count);
            const auto add = [&](const sourceGroup& group)
            {
                targets.particles.D == 2
              ? listSources<2>(group, box, members, reach, listed)
              : listSources<3>(group, box, members, reach, listed);
            };
            now.begin = part.size();
            listed.clear();
            add(groups.fluid);
            add(groups.halo);
            now.fluid = listed.appendTo(part);
            now.fluidEnd = part.size();
            listed.clear();
            add(groups.wall);
            now.wall = listed.appendTo(part);
            now.end = part.size();
        }
        parts_[firstPart + t] = std::move(part);
    }

    nPairs_ = 0;
    for (const cluster& c : clusters_)
    {
        nPairs_ += double(c.end - c.begin)*c.count;
    }
}

void clusterList::build
(
    const sourceGroup& targets,
    const double reach,
    const sourceGroups& groups
)
{
    const particleClusters& formed = *targets.clusters;
    clusters_.clear();
    clusters_.reserve(formed.size());
    for (int c = 0; c < formed.size(); ++c)
    {
        clusters_.push_back
        (
            {targets.offset + formed.first(c), formed.count(c), 0, 0, 0, 0, 0, 0}
        );
    }
    nTargets_ = targets.particles.n;

    // A few per thread: some clusters have more to search than others
    const int nParts = 8*omp_get_max_threads();
    parts_.resize(2*nParts);
    for (int t = nParts; t < 2*nParts; ++t)
    {
        parts_[t].clear();
    }
    std::vector<int> all(size());
    std::iota(all.begin(), all.end(), 0);
    list(all, 0, targets, reach, groups);
}

void clusterList::renew
(
    const std::vector<int>& which,
    const sourceGroup& targets,
    const double reach,
    const sourceGroups& groups
)
{
    list(which, int(parts_.size())/2, targets, reach, groups);
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
