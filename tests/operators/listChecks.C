/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The cluster lists hold every pair in reach exactly once, whatever the width
    of the clusters and of the cells, also those that were renewed.

\*---------------------------------------------------------------------------*/

#include "clusterShares.H"
#include "pairRig.H"

#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What is wrong with a list
struct listFaults
{
    //- Targets in no cluster or in two
    int targets = 0;

    //- Clusters with more than width targets or an edge beyond the longest
    int clusters = 0;

    //- Pairs in reach that are absent
    int missing = 0;

    //- Sources listed twice, or as of the other group
    int wrong = 0;

    //- Sources listed though out of reach of the box of their cluster
    int idle = 0;

    int sum() const
    {
        return targets + clusters + missing + wrong + idle;
    }
};


static listFaults examine
(
    const ulph::clusterList& list,
    const pairRig& rig,
    const ulph::clusterList::sourceGroup& targets,
    const int nSources,
    const int width,
    const double reach,
    const std::vector<int>& which
)
{
    const particleSample& s = rig.sample;
    listFaults faults;
    std::vector<int> taken(targets.particles.n, 0);

    for (const int c : which)
    {
        const ulph::clusterList::cluster& now = list[c];
        vec lower(vec::Constant(GREAT));
        vec upper(-lower);
        for (int l = 0; l < now.count; ++l)
        {
            ++taken[now.first - targets.offset + l];
            lower = lower.cwiseMin(s.x[now.first + l]);
            upper = upper.cwiseMax(s.x[now.first + l]);
        }
        faults.clusters +=
            now.count > width || (upper - lower).maxCoeff() > rig.longest;

        std::vector<int> listed(s.size(), 0);
        const auto look = [&](const std::uint32_t J, const bool asFluid)
        {
            faults.wrong += ++listed[J] > 1;
            faults.wrong += asFluid != (int(J) < s.nFluid);
            const vec outside
            (
                (lower - s.x[J]).cwiseMax(s.x[J] - upper).cwiseMax(vec::Zero())
            );
            faults.idle += outside.norm() > (1 + 1e-5)*reach;
        };
        list.fluid(now).goThrough([&](const std::uint32_t J)
        {
            look(J, true);
            return true;
        });
        list.wall(now).goThrough([&](const std::uint32_t J)
        {
            look(J, false);
            return true;
        });
        for (int l = 0; l < now.count; ++l)
        {
            for (int J = 0; J < nSources; ++J)
            {
                faults.missing +=
                    !listed[J]
                 && (s.x[J] - s.x[now.first + l]).norm() < reach;
            }
        }
    }
    for (const int n : taken)
    {
        faults.targets += n > 1;
    }
    faults.targets +=
        int(which.size()) == list.size() && std::count(taken.begin(), taken.end(), 0);
    return faults;
}


static std::vector<int> everyCluster(const ulph::clusterList& list, const int nth)
{
    std::vector<int> which;
    for (int c = 0; c < list.size(); c += nth)
    {
        which.push_back(c);
    }
    return which;
}


//- After particles have moved, every third list is renewed: it must be right, the
//- others as they were
static int renewalFaults(pairRig& rig, const int width, const double reach)
{
    const ulph::clusterList& list = rig.fluidList;
    const std::vector<int> which(everyCluster(list, 3));
    const auto others = [&]()
    {
        std::vector<std::uint32_t> sources;
        for (int c = 0; c < list.size(); ++c)
        {
            const auto add = [&](const std::uint32_t J)
            {
                sources.push_back(J);
                return true;
            };
            if (c % 3)
            {
                list.fluid(list[c]).goThrough(add);
                list.wall(list[c]).goThrough(add);
            }
        }
        return sources;
    };
    const std::vector<std::uint32_t> before(others());

    const double farthest = 0.5*rig.sample.dx;
    randomVectors random(rig.sample.D, 29);
    for (int i = 0; i < rig.sample.nFluid; ++i)
    {
        rig.sample.x[i] += random.vector(farthest);
    }
    rig.longest += 4*farthest;
    rig.renew(which, reach);
    const listFaults renewed
    (
        examine(list, rig, rig.fluid, rig.sample.size(), width, reach, which)
    );
    return renewed.sum() + int(others() != before);
}


//- Traces of the moment matrices, sum w V |x|^2
class momentTraces
:
    public ulph::sumSink<ulph::geometryBlock>
{
public:

    std::vector<double> trace;

    explicit momentTraces(const int n)
    :
        trace(n, 0)
    {}

    void take(const ulph::geometryBlock& sums) override
    {
        for (int l = 0; l < sums.count; ++l)
        {
            trace[sums.first + l] = sums.M[0][l] + sums.M[3][l] + sums.M[5][l];
        }
    }
};


// Every cluster must come to one thread, once, also where threads outnumber clusters
static int sharingFaults()
{
    int faults = 0;
    const int all = omp_get_max_threads();
    for (const int nThreads : {1, 2, 5})
    {
        omp_set_num_threads(nThreads);
        for (const int n : {0, 1, 15, 16, 17, 80, 1000})
        {
            std::vector<std::atomic<int>> visits(n + 64);
            ulph::clusterShares shares(n);

            #pragma omp parallel
            for (const int i : shares)
            {
                ++visits[i];
            }
            for (int i = 0; i < int(visits.size()); ++i)
            {
                faults += visits[i] != (i < n);
            }
        }
    }
    omp_set_num_threads(all);
    return faults;
}


// Among so many particles the next source may be farther off than one step reaches,
// and what lies between must not count: packed positions wrap around
static void longWays(tally& t)
{
    constexpr int n = 66;
    const double dx = 0.1;
    const double reach = 4.2*dx;

    randomVectors random(3, 11);
    std::array<std::vector<double>, 3> x;
    for (int i = 0; i < n*n*n; ++i)
    {
        const vec place
        (
            dx*vec(i % n, i/n % n, i/(n*n)) + random.vector(0.3*dx)
        );
        for (int k = 0; k < 3; ++k)
        {
            x[k].push_back(place[k]);
        }
    }
    ulph::particleClusters clusters
    (
        std::make_shared<ulph::cellCurve>
        (
            ulph::cellLayout
            (
                3,
                std::array<double, 3>{-dx, -dx, -dx},
                std::array<double, 3>{n*dx, n*dx, n*dx},
                8*dx
            )
        )
    );
    ulph::particleView view{3, n*n*n, {x[0].data(), x[1].data(), x[2].data()}};
    // Which particle is where
    std::vector<int> number(view.n);
    std::iota(number.begin(), number.end(), 0);
    const auto sort = [&](const int width)
    {
        const std::vector<int> order(clusters.sort(view, width));
        const auto permute = [&](auto& values)
        {
            const auto old(values);
            for (std::size_t i = 0; i < old.size(); ++i)
            {
                values[i] = old[order[i]];
            }
        };
        permute(number);
        for (int k = 0; k < 3; ++k)
        {
            permute(x[k]);
        }
        clusters.fit(view);
    };

    const ulph::clusterList::sourceGroup all{&clusters, view, 0};
    ulph::clusterList list;
    const auto traces = [&](const bool mixed)
    {
        const auto sums(ulph::pairSums::New("WendlandC2", mixed, 3, 4*dx));
        sums->resize(view.n);
        sort(sums->width());
        for (int first = 0; first < view.n; first += ulph::maxLanes)
        {
            ulph::geometryTile tile = {};
            const int count = std::min(ulph::maxLanes, view.n - first);
            for (int l = 0; l < count; ++l)
            {
                tile.V[l] = 1;
                for (int k = 0; k < 3; ++k)
                {
                    tile.x[k][l] = x[k][first + l];
                }
            }
            sums->pack(first, count, tile);
        }
        list.build(all, reach, {all, {}, {}});
        momentTraces sink(view.n);
        sums->geometry(list, {}, ulph::momentSums, sink);
        std::vector<double> trace(view.n);
        for (int i = 0; i < view.n; ++i)
        {
            trace[number[i]] = sink.trace[i];
        }
        return trace;
    };
    const std::vector<double> exact(traces(false));
    const std::vector<double> mixed(traces(true));
    double worst = 0;
    for (int i = 0; i < view.n; ++i)
    {
        worst = std::max(worst, std::abs(mixed[i]/exact[i] - 1));
    }

    int faults = 0;
    int nLong = 0;
    for (int c = 0; c < list.size(); c += list.size()/71)
    {
        const ulph::clusterList::cluster& now = list[c];
        std::vector<int> listed(view.n, 0);
        const ulph::clusterList::sources fluid(list.fluid(now));
        nLong += std::count(fluid.firstStep, fluid.lastStep, fluid.onTheWay);
        fluid.goThrough([&](const std::uint32_t J)
        {
            return ++listed[J];
        });
        for (int J = 0; J < view.n; ++J)
        {
            double nearest = GREAT;
            for (int i = now.first; i < now.first + now.count; ++i)
            {
                const vec r(x[0][J] - x[0][i], x[1][J] - x[1][i], x[2][J] - x[2][i]);
                nearest = std::min(nearest, r.norm());
            }
            faults += listed[J] != (nearest < reach);
        }
    }
    const std::string what("list of " + std::to_string(view.n) + " particles: ");
    t.check(what + "faults", faults, 0.0);
    t.check(what + "ways longer than a step", nLong > 10);
    t.check(what + "moments in mixed precision against double", worst, 1e-5);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::listChecks(tally& t)
{
    t.check("clusters shared out to threads: faults", sharingFaults(), 0.0);
    longWays(t);
    for (const int D : {2, 3})
    {
        for (const bool spray : {false, true})
        {
            const particleSample sample
            (
                spray ? particleSample::spray(D) : particleSample::block(D)
            );
            const double dx = sample.dx;
            const double reach = 4.2*dx;

            for (const int width : {1, 3, 4, 8, 16})
            {
                for (const double cell : {8*dx, 2*dx})
                {
                    pairRig rig(sample, width, reach, cell);

                    const listFaults fluid
                    (
                        examine
                        (
                            rig.fluidList, rig, rig.fluid, sample.size(),
                            width, reach, everyCluster(rig.fluidList, 1)
                        )
                    );
                    const listFaults wall
                    (
                        examine
                        (
                            rig.wallList, rig, rig.wall, sample.nFluid,
                            width, reach, everyCluster(rig.wallList, 1)
                        )
                    );
                    const std::string what
                    (
                        std::to_string(D) + "D "
                      + (spray ? "spray" : "block")
                      + " list of width " + std::to_string(width)
                      + ", cells of " + text(cell/dx) + " dx: "
                    );
                    t.check(what + "faults", fluid.sum() + wall.sum(), 0.0);
                    t.check
                    (
                        what + "faults of lists renewed",
                        renewalFaults(rig, width, reach),
                        0.0
                    );
                }
            }
        }
    }
}


// ************************************************************************* //
