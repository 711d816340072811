/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Equations of state and body forces against their formulas.

\*---------------------------------------------------------------------------*/

#include "scenes.H"

#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- p and its inverse; the energy against the integral of p/rho^2
static void stateChecks
(
    tally& t,
    const scene& where,
    const testCase& room,
    const std::string& model,
    const double gamma
)
{
    const rig library
    (
        room,
        where.properties(false) + "equationOfState " + model,
        where.state
    );
    const equationOfState& state = *library.models.state;
    const double rho0 = library.cloud.rho0();
    const double stiffness = rho0*sqr(library.cloud.c0())/gamma;
    const auto exact = [&](const double rho1)
    {
        return stiffness*double(std::pow(1 + (long double)(rho1)/rho0, gamma) - 1);
    };

    deviation p, inverse, energy;
    for (const double rho1 : {-200.0, -10.0, -1e-3, 0.0, 1e-3, 1.0, 50.0, 300.0})
    {
        p.add(state.pressure(rho1), exact(rho1));
        inverse.add(state.densityExcess(state.pressure(rho1)), rho1);

        // Simpson's rule
        const int n = 2000;
        double sum = 0;
        for (int i = 0; i <= n; ++i)
        {
            const double r = rho1*i/n;
            const int weight = i == 0 || i == n ? 1 : i % 2 ? 4 : 2;
            sum += weight*exact(r)/sqr(rho0 + r);
        }
        energy.add(state.energy(rho1), sum*rho1/n/3);
    }
    t.check(model + " p", p.relative(), 1e-14);
    t.check(model + " inverse", inverse.relative(), 1e-14);
    t.check(model + " energy", energy.relative(), 1e-10);
}


static void forceChecks
(
    tally& t,
    const scene& where,
    const testCase& room,
    const std::string& model,
    const std::function<vec(const vec&, const vec&, const double)>& exact,
    const double bound = 1e-13
)
{
    const rig library
    (
        room, where.properties(false) + "bodyForce " + model, where.state
    );
    deviation error;
    randomVectors random(where.D, 29);
    for (const double time : {0.0, 0.3, 0.9})
    {
        const vec x(random.vector(1));
        const vec v(random.vector(1));
        error.add
        (
            library.solved
            (
                library.models.force->at(time)
                (
                    library.unsolved(x), library.unsolved(v)
                )
            ),
            exact(x, v, time)
        );
    }
    t.check(where.name + " bodyForce " + model, error.absolute(), bound);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::modelChecks(tally& t)
{
    const scene ball(scene::ball(2));
    const testCase square(ball.name);
    stateChecks(t, ball, square, "linear;", 1);
    stateChecks(t, ball, square, "{ type Tait; gamma 7; }", 7);
    stateChecks(t, ball, square, "{ type Tait; gamma 1; }", 1);

    for (const int D : {2, 3})
    {
        const scene tank(scene::tank(D));
        const testCase room(tank.name);

        // The 2D tank lies in the plane of x and z
        const auto solved = [&](const double x, const double y, const double z)
        {
            return D == 2 ? vec(x, z, 0) : vec(x, y, z);
        };
        const vec g(solved(0, 0, -9.81));
        const vec centre(solved(0.1, -0.2, 0.3));
        const vec slope(solved(1, 2, 4));

        forceChecks
        (
            t, tank, room, "none;",
            [](const vec&, const vec&, double) { return vec(vec::Zero()); }
        );
        forceChecks
        (
            t, tank, room, "gravity;",
            [&](const vec&, const vec&, double) { return g; }
        );
        forceChecks
        (
            t, tank, room, "{ type central; Psi 3; centre (0.1 -0.2 0.3); }",
            [&](const vec& x, const vec&, double) { return vec(-9*(x - centre)); }
        );
        const std::string table("acceleration table ((0 (0 0 0)) (1 (1 2 4)));");
        forceChecks
        (
            t, tank, room, "{ type Function1; " + table + " }",
            [&](const vec&, const vec&, double time) { return vec(g + time*slope); }
        );
        forceChecks
        (
            t, tank, room, "{ type Function1; gravity no; " + table + " }",
            [&](const vec&, const vec&, double time) { return vec(time*slope); }
        );

        // Turns about the y axis, with omega = 2: x along the tank's first axis,
        // z along the vertical one
        forceChecks
        (
            t, tank, room,
            "{ type tankMotion; solidBodyMotionFunction rotatingMotion;"
            "  origin (0 0 0); axis (0 1 0); omega 2; }",
            [&](const vec& x, const vec& v, double time)
            {
                const int k = D == 2 ? 1 : 2;
                vec f(vec::Zero());
                f[0] = 9.81*std::sin(2*time) + 4*x[0] - 4*v[k];
                f[k] = -9.81*std::cos(2*time) + 4*x[k] + 4*v[0];
                return f;
            },
            1e-8
        );
    }
}


// ************************************************************************* //
