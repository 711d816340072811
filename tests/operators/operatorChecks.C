/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The right-hand side of the library against the printed equations.

\*---------------------------------------------------------------------------*/

#include "modelChoices.H"
#include "rightHandSideSinks.H"
#include "scenes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

const std::vector<modelChoice> choices
{
    {
        "full",
        "momentMatrix full; densityRelaxation none;"
        "densityDiffusion { type ULPH; delta 0.1; }"
        "viscosity { type artificial; alpha 0.1; symmetric yes; }",
        {0.1, 0.1, true, false, literal::inverse::full}
    },
    {
        "floored, C4",
        "kernel WendlandC4; wall noSlip; densityRelaxation none;"
        "momentMatrix { type eigenvalueFloored; floor 0.36; }"
        "densityDiffusion { type ULPH; delta 0.2; }"
        "viscosity { type artificial; alpha 0.05; }",
        {0.2, 0.05, true, true, literal::inverse::floored}
    },
    {
        "paper",
        "mode paper;",
        {0.1, 0.1, false, false, literal::inverse::optimal}
    },
    {
        "hydrostatic",
        "momentMatrix full; viscosity none;"
        "densityDiffusion { type hydrostatic; delta 0.1; }"
        "densityRelaxation { type moment; k 0.01; }",
        {0.1, 0, true, false, literal::inverse::full, true, 0.01}
    },
    {
        "Tait, laminar, laplacian",
        "momentMatrix full; densityRelaxation none;"
        "equationOfState { type Tait; gamma 7; }"
        "viscosity { type laminar; nu 0.01; }"
        "densityDiffusion { type laplacian; delta 0.1; }",
        {
            0.1, 0, true, false, literal::inverse::full, false, 0, true, 0.01, 7
        }
    }
};


void compare
(
    tally& t,
    const std::string& what,
    const rig& library,
    const literal::coefficients& printed,
    const double bound
)
{
    const literal exact(library, printed);
    const ulphCloud& cloud = library.cloud;
    const bool Fickian = library.models.shift->model() == "Fickian";

    deviation lambda, K, gradRho, div, Phi, relaxation, dvdt, shift, normal;
    int nNormals = 0;
    for (int i = 0; i < library.size(); ++i)
    {
        const literal::particle& I = exact.fluid[i];
        lambda.add(library.scalarOf("lambda", i), I.lambda);
        K.add(library.tensorOf("inverseMoment", i), I.K);
        if (library.has("densityGradient"))
        {
            gradRho.add(library.vectorOf("densityGradient", i), I.gradRho);
        }
        if (library.has("densityRelaxation"))
        {
            relaxation.add
            (
                library.scalarOf("densityRelaxation", i), I.relaxation
            );
        }
        div.add(library.scalarOf("divergence", i), I.div);
        Phi.add(library.diffusionOf(i), I.Phi);
        dvdt.add(library.vectorOf("acceleration", i), I.dvdt);
        shift.add
        (
            library.shiftOf(i),
            Fickian ? vec(cloud.h()/cloud.shared().beta*I.b) : I.R
        );
        if (library.scalarOf("surface", i) > 0)
        {
            ++nNormals;
            normal.add(library.vectorOf("normal", i), I.normal);
        }
    }

    t.check(what + " lambda", lambda.relative(), bound);
    t.check(what + " K", K.relative(), bound);
    t.check(what + " grad rho", gradRho.relative(), bound);
    t.check(what + " div v", div.relative(), bound);
    t.check(what + " Phi", Phi.relative(), bound);
    t.check(what + " relaxation", relaxation.relative(), bound);
    t.check(what + " dv/dt", dvdt.relative(), bound);
    t.check(what + " shift", shift.relative(), bound);
    t.check(what + " normals", normal.absolute(), 100*bound);
    t.check(what + " has a surface", nNormals > 10);
}


static void literalChecks(tally& t, const scene& where, const bool mixed)
{
    const testCase room(where.name);
    for (const modelChoice& choice : choices)
    {
        const std::string what
        (
            where.name + (mixed ? " mixed " : " double ") + choice.name
        );
        rig library
        (
            room, where.properties(mixed) + choice.properties, where.state
        );
        library.evaluate();
        compare(t, what, library, choice.printed, mixed ? 2e-5 : 1e-12);
    }
}


//- The passes taken one after the other, as driftKickDrift does it
static void splitChecks(tally& t, const scene& where)
{
    const testCase room(where.name);
    const modelChoice& choice = choices[0];
    rig library(room, where.properties(false) + choice.properties, where.state);

    library.rates.updateNeighbours(0);
    library.rates.geometry(0);
    library.rates.findSurface();
    library.rates.force(0, 0, true);

    // The force pass sees the old velocity, the divergence pass the new one
    const literal before(library, choice.printed);
    deviation dvdt;
    randomVectors random(library.cloud.D(), 17);
    for (int i = 0; i < library.size(); ++i)
    {
        dvdt.add(library.vectorOf("acceleration", i), before.fluid[i].dvdt);
        const vec v(random.vector(3));
        for (int k = 0; k < library.cloud.D(); ++k)
        {
            library.cloud.v().component(k)[i] = v[k];
        }
    }
    library.rates.divergence(0, 0);
    t.check(where.name + " split dv/dt", dvdt.relative(), 1e-12);

    const particleField* const afterKick =
        library.cloud.saved("divergenceAfterKick");
    t.check
    (
        where.name + " divergence after the kick where there are walls",
        bool(afterKick) == library.search().hasWalls()
    );
    if (!afterKick)
    {
        return;
    }

    // Left out are only particles that see no wall
    const literal after(library, choice.printed);
    deviation div;
    int nTaken = 0;
    int nLeftOut = 0;
    for (int i = 0; i < library.size(); ++i)
    {
        const literal::particle& I = after.fluid[i];
        if ((*afterKick)(i) != divergenceSink::notTaken)
        {
            ++nTaken;
            div.add((*afterKick)(i), I.div);
        }
        else
        {
            nLeftOut += I.seesWalls;
        }
    }
    t.check(where.name + " split div v", div.relative(), 1e-12);
    t.check(where.name + " split div v taken", nTaken > 10);
    t.check(where.name + " split div v left out beside walls", nLeftOut, 0.0);
}


//- Forces and divergence of new velocities in one pass, as predictorCorrector
//- takes it
static void frozenChecks(tally& t, const scene& where)
{
    const testCase room(where.name);
    for (const modelChoice& choice : choices)
    {
        rig library
        (
            room, where.properties(false) + choice.properties, where.state
        );
        library.evaluate();
        std::vector<scalar> Phi;
        randomVectors random(library.cloud.D(), 19);
        for (int i = 0; i < library.size(); ++i)
        {
            Phi.push_back(library.diffusionOf(i));
            const vec v(random.vector(3));
            for (int k = 0; k < library.cloud.D(); ++k)
            {
                library.cloud.v().component(k)[i] = v[k];
            }
        }
        library.rates.frozenForce(0, 0, 0);

        const literal after(library, choice.printed);
        deviation div;
        deviation dvdt;
        bool samePhi = true;
        for (int i = 0; i < library.size(); ++i)
        {
            const literal::particle& I = after.fluid[i];
            div.add(library.scalarOf("divergence", i), I.div);
            dvdt.add(library.vectorOf("acceleration", i), I.dvdt);
            samePhi = samePhi && library.diffusionOf(i) == Phi[i];
        }
        const std::string what(where.name + " frozen " + choice.name);
        t.check(what + " div v", div.relative(), 1e-12);
        t.check(what + " dv/dt", dvdt.relative(), 1e-12);
        t.check(what + " Phi stays", samePhi);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::operatorChecks(tally& t)
{
    for (const scene& where : scene::all())
    {
        literalChecks(t, where, false);
        literalChecks(t, where, true);
        splitChecks(t, where);
        frozenChecks(t, where);
    }
    neighbourChecks(t);
    linearChecks(t);
    latticeChecks(t);
    flowChecks(t);
}


// ************************************************************************* //
