/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The divergence of flows whose divergence is known.

\*---------------------------------------------------------------------------*/

#include "scenes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Flow towards the floor and aside along it keeps its volume
static void stagnationChecks(tally& t, const int D)
{
    scene where(scene::tank(D));
    const testCase room(where.name);
    const vec size(D == 2 ? vec(1, 0.8, 0) : vec(0.4, 0.32, 0.32));
    const auto aside = [&](const vec& x)
    {
        vec d(x - 0.5*size);
        d[D - 1] = 0;
        return d;
    };
    for (int i = 0; i < where.state.size(); ++i)
    {
        vec& v = where.state.v[i];
        v = aside(where.state.x[i]);
        v[D - 1] = -(D - 1)*where.state.x[i][D - 1];
    }
    rig library(room, where.properties(false), where.state);
    library.evaluate();

    // The row on the floor, as good as out of reach of the other walls
    deviation div;
    double sum = 0;
    int n = 0;
    for (int i = 0; i < library.size(); ++i)
    {
        const vec x(library.solved(library.cloud.position(i)));
        const vec toWalls(0.5*size - aside(x).cwiseAbs());
        if (x[D - 1] < where.dx && toWalls.head(D - 1).minCoeff() > 3*where.dx)
        {
            div.add(library.scalarOf("divergence", i), 0);
            sum += library.scalarOf("divergence", i);
            ++n;
        }
    }
    const std::string what(where.name + " flow against the floor: ");
    t.check(what + "particles", n > 3);
    t.check(what + "div v", div.absolute(), 0.04*(D - 1));
    t.check(what + "mean of div v", std::abs(sum/n), 0.02*(D - 1));
}


//- Fluid that turns with its tank keeps its volume
static void turningChecks(tally& t, const int D)
{
    scene where(scene::tank(D));
    const testCase room(where.name);
    mat W(mat::Zero());
    W(0, 1) = -0.7;
    W(1, 0) = 0.7;
    for (int i = 0; i < where.state.size(); ++i)
    {
        where.state.v[i] = W*where.state.x[i];
        where.state.rho1[i] = 0;
    }
    rig library
    (
        room,
        where.properties(false)
      + "wallMotion { solidBodyMotionFunction rotatingMotion;"
        "origin (0 0 0); omega 0.7; axis "
      + (D == 2 ? "(0 -1 0); }" : "(0 0 1); }"),
        where.state
    );
    library.evaluate();
    deviation div;
    for (int i = 0; i < library.size(); ++i)
    {
        div.add(library.scalarOf("divergence", i), 0);
    }
    t.check(where.name + " turning with its tank: div v", div.absolute(), 1e-12);
}


//- The divergence at positions that are ahead of the velocities, as
//- driftKickDrift takes it: of a field A x that stretches and turns it is that
//- before, for a tank that turns, too
static void aheadChecks(tally& t, const int D)
{
    const scene where(scene::ball(D));
    const testCase room(where.name);
    const scalar ahead = 1e-3;
    const std::string turning
    (
        "wallMotion { solidBodyMotionFunction rotatingMotion;"
        "origin (0 0 0); axis (0 0 1); omega 0.7; }"
    );

    randomVectors random(D, 17);
    mat A(mat::Zero());
    for (int k = 0; k < D; ++k)
    {
        A.col(k) = random.vector(1);
    }
    mat W(mat::Zero());
    W(0, 1) = -0.7;
    W(1, 0) = 0.7;

    for (const bool turns : {false, true})
    {
        const mat relative(turns ? mat(A - W) : A);
        fluidState state(where.state);
        for (int i = 0; i < state.size(); ++i)
        {
            state.v[i] = A*state.x[i];
            state.x[i] += ahead*relative*state.x[i];
        }
        rig library
        (
            room,
            where.properties(false) + "momentMatrix full; densityDiffusion none;"
            "shifting none; freeSurface none;" + (turns ? turning : ""),
            state
        );
        library.rates.updateNeighbours(0);
        library.rates.geometry(0, ahead);

        deviation div;
        for (int i = 0; i < library.size(); ++i)
        {
            div.add(library.scalarOf("divergence", i), A.trace());
        }
        const mat left(A*A*relative);
        t.check
        (
            where.name + (turns ? " turning" : " resting")
          + " div v at positions ahead",
            div.absolute(),
            1.1*sqr(ahead)*mag(left.trace()) + 1e-12
        );
        t.checkAbove
        (
            where.name + " which counts",
            ahead*mag((A*relative).trace()),
            20*sqr(ahead)*mag(left.trace())
        );
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::flowChecks(tally& t)
{
    for (const int D : {2, 3})
    {
        stagnationChecks(t, D);
        turningChecks(t, D);
        aheadChecks(t, D);
    }
}


// ************************************************************************* //
