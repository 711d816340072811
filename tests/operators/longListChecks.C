/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Lists of so many particles that the next source may be farther off than one step
    of a list reaches. What lies between must not count: packed positions wrap
    around.

\*---------------------------------------------------------------------------*/

#include "pairRig.H"

#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

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

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::longListChecks(tally& t)
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
        const ulph::particleOrder order(clusters.sort(view, width));
        ulph::permute(number.data(), order);
        for (int k = 0; k < 3; ++k)
        {
            ulph::permute(x[k].data(), order);
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


// ************************************************************************* //
