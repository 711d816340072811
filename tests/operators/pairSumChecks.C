/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The pair sums of the library against a double loop over all pairs.

\*---------------------------------------------------------------------------*/

#include "pairRig.H"

#include <stdexcept>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Rows of a block in the order of its groups
static std::vector<const ulph::laneRow*> rowsOf(const ulph::geometryBlock& s)
{
    return {s.M, s.b, s.G, s.Q, s.L, &s.n, &s.d, s.e};
}


static std::vector<const ulph::laneRow*> rowsOf(const ulph::forceBlock& s)
{
    return {s.pressure, s.H, s.A, s.symmetricA, s.b, s.L};
}


static std::vector<const ulph::laneRow*> rowsOf
(
    const ulph::interpolationBlock& s
)
{
    return {&s.w, s.x, &s.s, s.sx, s.v};
}


//- Compares what a pass hands over
template<class Block>
class comparison
:
    public ulph::sumSink<Block>
{
    const int D_;

    const int firstTarget_;

    const unsigned flags_;

    const std::vector<sumGroup>& groups_;

    const sumRows& exact_;

public:

    std::vector<deviation> errors;

    std::vector<int> taken;

    comparison
    (
        const int D,
        const int firstTarget,
        const unsigned flags,
        const std::vector<sumGroup>& groups,
        const sumRows& exact
    )
    :
        D_(D),
        firstTarget_(firstTarget),
        flags_(flags),
        groups_(groups),
        exact_(exact),
        errors(groups.size()),
        taken(exact.size(), 0)
    {}

    void take(const Block& sums) override
    {
        const std::vector<const ulph::laneRow*> rows(rowsOf(sums));

        #pragma omp critical
        for (int l = 0; l < sums.count; ++l)
        {
            const int target = sums.first + l - firstTarget_;
            ++taken[target];
            for (std::size_t g = 0; g < groups_.size(); ++g)
            {
                const sumGroup& group = groups_[g];
                if ((flags_ & group.flag) != group.flag)
                {
                    continue;
                }
                for (int c = 0; c < group.size[D_ - 2]; ++c)
                {
                    errors[g].add
                    (
                        rows[g][c][l], exact_[target][group.first + c]
                    );
                }
            }
        }
    }

    void judge(tally& t, const std::string& what, const double bound) const
    {
        double worst = 0;
        std::string name;
        for (std::size_t g = 0; g < groups_.size(); ++g)
        {
            if (!(errors[g].relative() <= worst))
            {
                worst = errors[g].relative();
                name = std::string(" ") + groups_[g].name;
            }
        }
        t.check(what + name, worst, bound);
    }
};


//- Run a pass for every set of sums that the library compiles
template<class Pass>
static void forCompiledSets(const Pass& pass)
{
    for (unsigned set = 0; set < 32; ++set)
    {
        try
        {
            pass(set);
        }
        catch (const std::logic_error&)
        {}
    }
}


static void compare
(
    tally& t,
    const std::string& what,
    const pairRig& rig,
    ulph::pairSums& sums,
    const std::string& kernel,
    const double h,
    const double bound
)
{
    const particleSample& s = rig.sample;
    const bruteSums brute(s, kernel, h);
    const double eta2 = sqr(0.1*h);
    const sumRows geometry(brute.geometry(s.size()));
    const sumRows overFluid(brute.geometry(s.nFluid));

    forCompiledSets([&](const unsigned set)
    {
        comparison<ulph::geometryBlock> all
        (
            s.D, 0, set, geometryGroups, geometry
        );
        sums.geometry(rig.fluidList, {}, set, all);
        all.judge(t, what + "geometry " + std::to_string(set), bound);
    });
    {
        // Every other cluster, fluid sources only
        std::vector<unsigned char> mask(rig.fluidList.size());
        std::vector<int> expected(s.nFluid, 0);
        for (int c = 0; c < rig.fluidList.size(); ++c)
        {
            mask[c] = c % 2;
            for (int l = 0; l < rig.fluidList[c].count; ++l)
            {
                expected[rig.fluidList[c].first + l] = c % 2;
            }
        }
        comparison<ulph::geometryBlock> some
        (
            s.D, 0, 1 | 2, geometryGroups, overFluid
        );
        sums.geometry(rig.fluidList, {mask.data(), true}, 1 | 2, some);
        some.judge(t, what + "geometry of half the clusters", bound);
        t.check(what + "those clusters only", some.taken == expected);

        const sumRows fluidForce(brute.force(s.nFluid, eta2));
        comparison<ulph::forceBlock> someForces
        (
            s.D, 0, ulph::divergenceSums, forceGroups, fluidForce
        );
        rig.pack(sums, ulph::divergenceSums);
        sums.force
        (
            rig.fluidList, {mask.data(), true}, ulph::divergenceSums, {eta2}, someForces
        );
        someForces.judge(t, what + "force of half the clusters", bound);
        t.check(what + "those only, too", someForces.taken == expected);
    }

    const sumRows force(brute.force(s.size(), eta2));
    forCompiledSets([&](const unsigned set)
    {
        comparison<ulph::forceBlock> all(s.D, 0, set, forceGroups, force);
        rig.pack(sums, set);
        sums.force(rig.fluidList, {}, set, {eta2}, all);
        all.judge(t, what + "force " + std::to_string(set), bound);
    });

    if (s.size() > s.nFluid)
    {
        const sumRows averages(brute.interpolation());
        forCompiledSets([&](const unsigned set)
        {
            comparison<ulph::interpolationBlock> all
            (
                s.D, s.nFluid, set, interpolationGroups, averages
            );
            sums.interpolate(rig.wallList, set, all);
            all.judge(t, what + "interpolation " + std::to_string(set), bound);
        });
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::pairSumChecks(tally& t)
{
    for (const int D : {2, 3})
    {
        for (const std::string& kernel : ulph::pairSums::kernels())
        {
            for (const bool mixed : {false, true})
            {
                for (const bool spray : {false, true})
                {
                    const particleSample sample
                    (
                        spray
                      ? particleSample::spray(D)
                      : particleSample::block(D)
                    );
                    const double dx = sample.dx;
                    const double h = 2*dx;
                    const double skin = 0.2*dx;

                    const std::unique_ptr<ulph::pairSums> sums
                    (
                        ulph::pairSums::New(kernel, mixed, D, 2*h)
                    );
                    pairRig rig
                    (
                        sample, sums->width(), 2*h + skin, 8*dx
                    );

                    // The list must hold as long as the skin promises
                    randomVectors random(D, 7);
                    for (vec& x : rig.sample.x)
                    {
                        x += 0.499*skin*random.vector(1).normalized();
                    }
                    rig.pack(*sums, 0);

                    const std::string what
                    (
                        std::to_string(D) + "D " + kernel
                      + (mixed ? " mixed" : " double")
                      + (spray ? " spray " : " block ")
                    );
                    compare
                    (
                        t, what, rig, *sums, kernel, h, mixed ? 2e-6 : 1e-12
                    );
                }
            }
        }
    }

    const std::unique_ptr<ulph::pairSums> sums
    (
        ulph::pairSums::New("WendlandC2", false, 2, 1)
    );
    bool thrown = false;
    try
    {
        comparison<ulph::geometryBlock> none(2, 0, 0, geometryGroups, {});
        sums->geometry({}, {}, ulph::gradientSums, none);
    }
    catch (const std::logic_error&)
    {
        thrown = true;
    }
    t.check("a set of sums that is not compiled is refused", thrown);
}


// ************************************************************************* //
