/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Fields whose derivatives are known: linear ones, and lambda on a lattice.

\*---------------------------------------------------------------------------*/

#include "scenes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- lambda of the particle nearest to a place, in a block of lattice of m[k]
//- particles along direction k about the origin
static double latticeLambda
(
    const testCase& room,
    const scene& where,
    const std::array<int, 3>& m,
    const vec& place
)
{
    fluidState state;
    vec corner(vec::Zero());
    for (int k = 0; k < where.D; ++k)
    {
        corner[k] = 0.5*m[k]*where.dx;
    }
    for (const vec& x : jitteredLattice(where.D, where.dx, -corner, corner, 0))
    {
        state.x.push_back(x);
        state.v.push_back(vec::Zero());
        state.rho1.push_back(0);
        state.m.push_back(1000*std::pow(where.dx, where.D));
    }
    rig library(room, where.properties(false), state);
    library.evaluate();

    int nearest = 0;
    const auto distance = [&](const int i)
    {
        return
            (library.solved(library.cloud.position(i)) - place).norm();
    };
    for (int i = 0; i < library.size(); ++i)
    {
        nearest = distance(i) < distance(nearest) ? i : nearest;
    }
    return library.scalarOf("lambda", nearest);
}


static void latticeChecks
(
    tally& t,
    const int D,
    const double interior,
    const std::vector<double>& rows,
    const double accuracy
)
{
    const scene where(scene::ball(D));
    const testCase room(where.name);
    const double dx = where.dx;
    const int n = 13;
    const std::array<int, 3> m{n, n, n};
    const std::string what(std::to_string(D) + "D lambda ");

    t.check
    (
        what + "of the lattice",
        std::abs(latticeLambda(room, where, m, vec::Zero()) - interior),
        5e-6
    );
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
        const vec place(0, (0.5*n - 0.5 - row)*dx, 0);
        t.check
        (
            what + "of row " + std::to_string(row) + " under a flat surface",
            std::abs(latticeLambda(room, where, m, place) - rows[row]),
            accuracy
        );
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::linearChecks(tally& t)
{
    for (const int D : {2, 3})
    {
        scene where(scene::ball(D));
        const testCase room(where.name);

        randomVectors random(D, 19);
        const vec slope(random.vector(1));
        mat A(mat::Zero());
        for (int k = 0; k < D; ++k)
        {
            A.row(k) = random.vector(1);
        }
        for (int i = 0; i < where.state.size(); ++i)
        {
            where.state.rho1[i] = 1 + slope.dot(where.state.x[i]);
            where.state.v[i] = vec(1, 2, D == 2 ? 0 : 3) + A*where.state.x[i];
        }

        for (const bool mixed : {false, true})
        {
            rig library
            (
                room, where.properties(mixed) + "momentMatrix full;", where.state
            );
            library.evaluate();

            deviation gradient, divergence;
            for (int i = 0; i < library.size(); ++i)
            {
                gradient.add(library.vectorOf("densityGradient", i), slope);
                divergence.add(library.scalarOf("divergence", i), A.trace());
            }
            const std::string what
            (
                std::to_string(D) + "D" + (mixed ? " mixed " : " double ")
            );
            const double bound = mixed ? 1e-4 : 1e-12;
            t.check(what + "grad of a linear field", gradient.relative(), bound);
            t.check(what + "div of a linear field", divergence.relative(), bound);
        }
    }
}


void Foam::latticeChecks(tally& t)
{
    latticeChecks(t, 2, 1.11055, {0.555, 0.797, 1.070}, 5e-4);
    latticeChecks(t, 3, 1.06599, {0.533, 0.778, 1.036}, 5e-4);

    const scene where(scene::ball(2));
    const testCase room(where.name);
    const double corner = 6*where.dx;
    t.check
    (
        "2D lambda of a corner",
        std::abs
        (
            latticeLambda(room, where, {13, 13, 1}, vec(corner, corner, 0))
          - 0.234
        ),
        5e-4
    );
    const double sheets[] = {0, 0.242, 0.484, 0.555, 0.555};
    for (int rows = 1; rows <= 5; ++rows)
    {
        // The poorest row: of thin sheets the middle, of thick ones the edge
        const vec place(0, rows < 4 ? 0 : 0.5*rows*where.dx, 0);
        t.check
        (
            "2D lambda of a sheet of " + std::to_string(rows) + " rows",
            std::abs
            (
                latticeLambda(room, where, {13, rows, 1}, place)
              - sheets[rows - 1]
            ),
            5e-4
        );
    }
}


// ************************************************************************* //
