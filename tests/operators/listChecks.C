/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The cluster lists hold every pair in reach exactly once, whatever the width
    of the clusters and of the cells.

\*---------------------------------------------------------------------------*/

#include "pairRig.H"

#include <algorithm>

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

    //- Sources listed twice, or on the wrong side of fluidEnd
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
    const double longest
)
{
    const particleSample& s = rig.sample;
    listFaults faults;
    std::vector<int> taken(targets.particles.n, 0);

    for (int c = 0; c < list.size(); ++c)
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
            now.count > width || (upper - lower).maxCoeff() > longest;

        std::vector<int> listed(s.size(), 0);
        const std::uint32_t* const neighbours = list.neighbours(now);
        for (std::size_t j = now.begin; j < now.end; ++j)
        {
            const int J = int(neighbours[j]);
            faults.wrong += ++listed[J] > 1;
            faults.wrong += (j < now.fluidEnd) != (J < s.nFluid);
            const vec outside
            (
                (lower - s.x[J]).cwiseMax(s.x[J] - upper).cwiseMax(vec::Zero())
            );
            faults.idle += outside.norm() > (1 + 1e-5)*reach;
        }
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
        faults.targets += n != 1;
    }
    return faults;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::listChecks(tally& t)
{
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
                // The last longest edge cuts clusters of a compact block, too
                for (const double longest : {8*dx, 1*dx})
                {
                    const double cell = (width == 4 ? 4.2 : 2)*dx;
                    const pairRig rig(sample, width, reach, longest, cell);

                    const listFaults fluid
                    (
                        examine
                        (
                            rig.fluidList, rig, rig.fluid, sample.size(),
                            width, reach, longest
                        )
                    );
                    const listFaults wall
                    (
                        examine
                        (
                            rig.wallList, rig, rig.wall, sample.nFluid,
                            width, reach, longest
                        )
                    );
                    t.check
                    (
                        std::to_string(D) + "D "
                      + (spray ? "spray" : "block")
                      + " list of width " + std::to_string(width)
                      + ", edges to " + text(longest/dx)
                      + " dx: faults",
                        fluid.sum() + wall.sum(),
                        0.0
                    );
                }
            }
        }
    }
}


// ************************************************************************* //
