/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What must not change: linear momentum, results under rotation, results
    under the number of threads.

\*---------------------------------------------------------------------------*/

#include "scenes.H"

#include <omp.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const char* const viscous =
    "viscosity { type artificial; alpha 0.1; symmetric yes; }";


//- |sum m dv/dt| over sum m |dv/dt|, without walls and body force
static double momentumError
(
    const scene& where,
    const testCase& room,
    const std::string& models,
    const bool mixed
)
{
    rig library(room, where.properties(mixed) + models, where.state);
    library.evaluate();

    vec sum(vec::Zero());
    double size = 0;
    for (int i = 0; i < library.size(); ++i)
    {
        const vec a(library.vectorOf("acceleration", i));
        sum += library.cloud.mass()(i)*a;
        size += library.cloud.mass()(i)*a.norm();
    }
    return sum.norm()/size;
}


static void momentumChecks(tally& t, const int D)
{
    const scene where(scene::ball(D));
    const testCase room(where.name);
    const std::string what(std::to_string(D) + "D sum of m dv/dt, ");

    t.check
    (
        what + "default",
        momentumError(where, room, "mode default;", false),
        1e-13
    );
    t.check
    (
        what + "viscous",
        momentumError(where, room, viscous, false),
        1e-13
    );
    t.check
    (
        what + "viscous, mixed",
        momentumError(where, room, viscous, true),
        1e-7
    );
    t.checkAbove
    (
        what + "viscosity by K_I alone",
        momentumError
        (
            where, room, "viscosity { type artificial; alpha 0.1; symmetric no; }",
            false
        ),
        1e-6
    );
}


//- Largest differences between a cloud turned and its results turned
struct rotationErrors
{
    deviation lambda, divergence, diffusion, acceleration, shift, normal;

    int nClasses = 0;

    rotationErrors(const scene&, const testCase&, const std::string& models);
};


rotationErrors::rotationErrors
(
    const scene& where,
    const testCase& room,
    const std::string& models
)
{
    randomVectors random(where.D, 23);
    const mat R(random.rotation());

    const std::string properties(where.properties(false) + models);
    rig straight(room, properties, where.state);
    rig turned(room, properties, where.state.rotated(R));
    straight.evaluate();
    turned.evaluate();

    const std::vector<int> from(straight.places());
    const std::vector<int> to(turned.places());
    for (int p = 0; p < straight.size(); ++p)
    {
        const int i = from[p];
        const int j = to[p];
        const auto add = [&](deviation& error, const char* const field)
        {
            error.add(turned.scalarOf(field, j), straight.scalarOf(field, i));
        };
        add(lambda, "lambda");
        add(divergence, "divergence");
        diffusion.add(turned.diffusionOf(j), straight.diffusionOf(i));
        acceleration.add
        (
            turned.vectorOf("acceleration", j),
            vec(R*straight.vectorOf("acceleration", i))
        );
        shift.add
        (
            turned.shiftOf(j), vec(R*straight.shiftOf(i))
        );
        nClasses +=
            turned.scalarOf("surface", j) != straight.scalarOf("surface", i);
        if (straight.scalarOf("surface", i) > 0)
        {
            normal.add
            (
                turned.vectorOf("normal", j),
                vec(R*straight.vectorOf("normal", i))
            );
        }
    }
}


static void rotationChecks(tally& t, const int D)
{
    const scene where(scene::ball(D));
    const testCase room(where.name);
    const std::string what(std::to_string(D) + "D turned ");

    const rotationErrors e(where, room, viscous);
    t.check(what + "dv/dt", e.acceleration.relative(), 1e-12);
    t.check(what + "lambda", e.lambda.relative(), 1e-12);
    t.check(what + "div v", e.divergence.relative(), 1e-12);
    t.check(what + "Phi", e.diffusion.relative(), 1e-12);
    t.check(what + "shift", e.shift.relative(), 1e-12);
    t.check(what + "normals", e.normal.absolute(), 1e-11);
    t.check(what + "surface classes", e.nClasses, 0.0);

    // Eq. (39) holds for the axes chosen only
    t.checkAbove
    (
        what + "dv/dt with eq. (39)",
        rotationErrors(where, room, "momentMatrix optimal;")
            .acceleration.relative(),
        1e-3
    );
}


//- All fields of a run with some threads, in the order of the particles
static std::vector<double> fieldsOf
(
    const scene& where,
    const testCase& room,
    const std::string& models,
    const bool mixed,
    const int nThreads
)
{
    omp_set_num_threads(nThreads);
    rig library(room, where.properties(mixed) + models, where.state);
    library.evaluate();

    // Again after a rebuild, and the pass of the divergence alone
    library.neighbours.invalidate();
    library.evaluate();
    library.rates.divergence(0, 0);
    const particleField* const afterKick =
        library.cloud.saved("divergenceAfterKick");
    omp_set_num_threads(1);

    std::vector<double> values;
    for (int i = 0; i < library.size(); ++i)
    {
        values.push_back(library.cloud.origId()[i]);
        values.push_back
        (
            library.has("densityDiffusion") ? library.diffusionOf(i) : 0
        );
        values.push_back(afterKick ? (*afterKick)(i) : 0);
        for (const word& name : library.cloud.derivedNames())
        {
            const particleField& field = *library.cloud.derived(name);
            for (int c = 0; c < field.nComponents(); ++c)
            {
                values.push_back(field(i, c));
            }
        }
    }
    return values;
}


static void threadChecks(tally& t)
{
    for (const scene& where : scene::all())
    {
        const testCase room(where.name);
        for (const char* const models : {"mode default;", "mode paper;"})
        {
            for (const bool mixed : {false, true})
            {
                const std::vector<double> one
                (
                    fieldsOf(where, room, models, mixed, 1)
                );
                const std::vector<double> two
                (
                    fieldsOf(where, room, models, mixed, 2)
                );
                t.check
                (
                    where.name + (mixed ? " mixed " : " double ") + models
                  + " bits of one and two threads",
                    one == two
                );
            }
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::symmetryChecks(tally& t)
{
    for (const int D : {2, 3})
    {
        momentumChecks(t, D);
        rotationChecks(t, D);
    }
    threadChecks(t);
}


// ************************************************************************* //
