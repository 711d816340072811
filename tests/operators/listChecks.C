/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The cluster lists hold every pair in reach exactly once, whatever the width
    of the clusters and of the cells, also those that were renewed; and
    threads share the clusters out completely.

\*---------------------------------------------------------------------------*/

#include "clusterShares.H"
#include "pairRig.H"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <omp.h>

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

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::listChecks(tally& t)
{
    t.check("clusters shared out to threads: faults", sharingFaults(), 0.0);
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
