/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    Test-effects

Description
    What `none` costs. A family is absent from bareRates: that is continuity
    and momentum written by hand on the pair sums, with no object, field or
    branch for any effect. Against it stands the library's right-hand side.

    Where all families are none, results must have the same bits. Where one is
    none and the others are not, the pair passes must be those that the others
    need: the bare evaluation takes these sums, named here by hand.

    Under callgrind every evaluation becomes a dump; effects.py compares the
    instructions of the pair passes.

\*---------------------------------------------------------------------------*/

#include "bareRates.H"
#include "scenes.H"

#include <iostream>
#include <omp.h>
#include <valgrind/callgrind.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A choice of models, the pair sums it needs and its derived fields
struct effectCase
{
    const char* name;

    const char* models;

    unsigned geometry;

    unsigned force;

    const char* fields;
};

static constexpr unsigned core =
    ulph::momentSums | ulph::velocityGradientSums;

static constexpr unsigned diffusion =
    ulph::gradientSums | ulph::laplacianSums;

static constexpr unsigned viscous =
    ulph::viscousSums | ulph::symmetricViscousSums;

static const effectCase cases[] =
{
    {
        "allNone",
        "densityDiffusion none; shifting none; viscosity none;"
        "freeSurface none; bodyForce none; densityRelaxation none;",
        core, ulph::pressureSums, ""
    },
    {
        "omitted",
        "densityDiffusion none; shifting none; freeSurface none;",
        core, ulph::pressureSums, ""
    },
    {
        "densityDiffusionNone",
        "densityDiffusion none;"
        "viscosity { type artificial; alpha 0.1; }",
        core, viscous, "lambda normal surface"
    },
    {
        "shiftingNone",
        "shifting none;"
        "viscosity { type artificial; alpha 0.1; }",
        core | diffusion, viscous | ulph::densityDiffusionSums,
        "densityDiffusion densityGradient lambda normal surface"
    },
    {
        "shiftingOn",
        "shifting { type XuStansbyLaurence; C 0.04; }"
        "viscosity { type artificial; alpha 0.1; }",
        core | diffusion | ulph::spacingSums,
        viscous | ulph::densityDiffusionSums,
        "densityDiffusion densityGradient lambda normal shift surface"
    },
    {
        "viscosityNone",
        "viscosity none;",
        core | diffusion, ulph::densityDiffusionSums,
        "densityDiffusion densityGradient lambda normal surface"
    },
    {
        "freeSurfaceNone",
        "freeSurface none;"
        "viscosity { type artificial; alpha 0.1; }",
        core | diffusion, viscous | ulph::densityDiffusionSums,
        "densityDiffusion densityGradient"
    }
};


//- Call f, counted by callgrind if that is running
template<class Function>
static void counted(const std::string& name, const Function& f)
{
    CALLGRIND_ZERO_STATS;
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_TOGGLE_COLLECT;
    f();
    CALLGRIND_TOGGLE_COLLECT;
    CALLGRIND_DUMP_STATS_AT(name.c_str());
    CALLGRIND_STOP_INSTRUMENTATION;
}


static bool sameBits(const particleField& a, const particleField& b)
{
    bool same = a.size() == b.size() && a.nComponents() == b.nComponents();
    for (int c = 0; same && c < a.nComponents(); ++c)
    {
        for (label i = 0; i < a.size(); ++i)
        {
            same = same && a(i, c) == b(i, c);
        }
    }
    return same;
}


static void check
(
    tally& t,
    const effectCase& now,
    const scene& where,
    const testCase& room,
    const bool mixed
)
{
    const std::string name
    (
        std::string(now.name) + std::to_string(where.D)
      + (mixed ? "Mixed" : "Double")
    );
    rig library
    (
        room,
        where.properties(mixed) + "momentMatrix full;" + now.models,
        where.state
    );
    library.evaluate();
    counted("library." + name, [&]() { library.evaluate(); });

    const bool bits = now.geometry == core && now.force == ulph::pressureSums;
    bareRates bare(library, now.geometry, now.force);
    bare.evaluate();
    counted("bare." + name, [&]() { bare.evaluate(); });

    const auto same = [&](const particleField& a, const char* const field)
    {
        return sameBits(a, *library.cloud.derived(field));
    };
    t.check
    (
        name + " bits of sums, K and divergence",
        same(bare.b, "kernelGradient")
     && same(bare.K, "inverseMoment")
     && same(bare.divergence, "divergence")
    );
    if (bits)
    {
        t.check
        (
            name + " bits of dv/dt", same(bare.acceleration, "acceleration")
        );
    }

    std::string fields;
    for (const word& field : library.cloud.derivedNames())
    {
        if
        (
            field != "acceleration" && field != "divergence"
         && field != "inverseMoment" && field != "kernelGradient"
        )
        {
            fields += (fields.empty() ? "" : " ") + field;
        }
    }
    t.check(name + " fields: " + now.fields, fields == now.fields);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    using namespace Foam;

    omp_set_num_threads(1);

    tally t;
    for (const int D : {2, 3})
    {
        const scene where(scene::ball(D));
        const testCase room(where.name);
        for (const effectCase& now : cases)
        {
            for (const bool mixed : {false, true})
            {
                check(t, now, where, room, mixed);
            }
        }
    }
    std::cout<< t.nPassed << " passed, " << t.nFailed << " failed" << std::endl;

    return t.nFailed || !t.nPassed ? 1 : 0;
}


// ************************************************************************* //
