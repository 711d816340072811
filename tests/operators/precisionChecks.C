/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Mixed against double precision in a hydrostatic column of a size that is
    computed with, where the force is the small difference of large pressures.

\*---------------------------------------------------------------------------*/

#include "scenes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The tank filled at rest; at random only the places, by a part of dx
static scene column
(
    const std::string& name,
    const int D,
    const double dx,
    const double jitter
)
{
    const double g = 9.81;
    const double c0 = 35;
    const vec size(D == 2 ? vec(1, 0.6, 0) : vec(0.4, 0.32, 0.28));

    scene where;
    where.name = name;
    where.D = D;
    where.dx = dx;
    for (const vec& x : jitteredLattice(D, dx, vec::Zero(), size, jitter))
    {
        const double p = 1000*g*(size[D - 1] - x[D - 1]);
        where.state.x.push_back(x);
        where.state.v.push_back(vec::Zero());
        where.state.rho1.push_back(p/sqr(c0));
        where.state.m.push_back(1000*std::pow(dx, D));
    }
    return where;
}


static void columnChecks
(
    tally& t,
    const std::string& name,
    const int D,
    const double jitter
)
{
    const scene where(column(name, D, D == 2 ? 0.005 : 0.01, jitter));
    const testCase room(where.name);

    rig exact(room, where.properties(false), where.state);
    rig mixed(room, where.properties(true), where.state);
    exact.evaluate();
    mixed.evaluate();

    const std::vector<int> from(exact.places());
    const std::vector<int> to(mixed.places());
    deviation acceleration, lambda;
    int nClasses = 0;
    for (int p = 0; p < exact.size(); ++p)
    {
        acceleration.add
        (
            mixed.vectorOf("acceleration", to[p]),
            exact.vectorOf("acceleration", from[p])
        );
        lambda.add
        (
            mixed.scalarOf("lambda", to[p]), exact.scalarOf("lambda", from[p])
        );
        nClasses +=
            mixed.scalarOf("surface", to[p])
         != exact.scalarOf("surface", from[p]);
    }
    const std::string what
    (
        name + " column of " + std::to_string(exact.size())
      + ", jitter " + text(jitter) + " dx, mixed: "
    );
    t.check(what + "dv/dt over g", acceleration.absolute()/9.81, 1.3e-4);
    t.check(what + "lambda", lambda.relative(), 3e-6);
    t.check(what + "surface classes", nClasses, 0.0);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::precisionChecks(tally& t)
{
    for (const double jitter : {0.0, 0.1})
    {
        columnChecks(t, "tank2D", 2, jitter);
        columnChecks(t, "tank3D", 3, jitter);

        // A long mesh must not cost positions their digits
        columnChecks(t, "flume2D", 2, jitter);
    }
}


// ************************************************************************* //
