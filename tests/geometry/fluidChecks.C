/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Checks of fluidLattice: numbers, places and volumes of particles.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "fluidLattice.H"
#include "mathematicalConstants.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

void column(tally& t)
{
    testCase c("box2D");
    const scalar dx = 0.01;

    fluidLattice fluid
    (
        c.mesh,
        c.search,
        parse
        (
            "dx 0.01; regions { column { source boxToPoint;"
            " box (0 0 -1) (0.6 0.3 1); velocity (1 0 0); pressure 7; } }"
        )
    );

    t.check
    (
        fluid.size() == 1800,
        "column of 0.6 x 0.3 m: " + text(fluid.size()) + " of 1800 particles"
    );

    const scalar gap = smallestGap(fluid.position(), dx);
    t.check
    (
        mag(gap - dx) < 1e-9*dx,
        "column: smallest distance " + text(gap/dx) + " dx"
    );

    const scalar area = sum(fluid.volume());
    t.check(mag(area - 0.18) < 1e-12, "column: area " + text(area) + " m2");

    bool values = true, place = true;
    forAll(fluid.position(), i)
    {
        values =
            values && fluid.velocity()[i] == vector(1, 0, 0)
         && fluid.pressure()[i] == 7 && fluid.region()[i] == 0;
        place = place && mag(fluid.position()[i].z() - 0.05) < 1e-12;
    }
    t.check(values, "column: velocity, pressure and region as given");
    t.check(place, "column: all particles on the mid-plane");

    fluidLattice cells
    (
        c.mesh,
        c.search,
        parse
        (
            "dx 0.01; regions { column { source boxToCell;"
            " box (0 0 -1) (0.6 0.3 1); } }"
        )
    );
    t.check
    (
        cells.size() == 1800,
        "column by boxToCell: " + text(cells.size()) + " of 1800 particles"
    );

    fluidLattice pair
    (
        c.mesh,
        c.search,
        parse
        (
            "dx 0.01; regions { left { source boxToPoint;"
            " box (0 0 -1) (0.3 0.3 1); } right { source sphereToPoint;"
            " sourceInfo { centre (1 0.5 0.05); radius 0.2; } } }"
        )
    );
    t.check
    (
        pair.size() > 900 && pair.region()[899] == 0 && pair.region()[900] == 1
     && mag(sum(pair.volume()) - 0.09 - constant::mathematical::pi*0.04) < 1e-3,
        "two regions: " + text(pair.size()) + " particles"
    );
}


void fromField(tally& t)
{
    testCase c("box2D");

    volScalarField alpha
    (
        IOobject("alpha.water", c.time.timeName(), c.mesh),
        c.mesh,
        dimensionedScalar(dimless, Zero)
    );

    forAll(alpha, celli)
    {
        const point& p = c.mesh.cellCentres()[celli];
        alpha[celli] = p.x() < 0.6 && p.y() < 0.3;
    }
    alpha.write();

    fluidLattice fluid
    (
        c.mesh,
        c.search,
        parse("dx 0.01; regions { column { field alpha.water; } }")
    );

    t.check
    (
        fluid.size() == 1800,
        "column from alpha.water: " + text(fluid.size()) + " of 1800 particles"
    );
}


void turned(tally& t)
{
    testCase c("turned2D");
    const scalar dx = 0.01;

    fluidLattice fluid
    (
        c.mesh,
        c.search,
        parse
        (
            "dx 0.01; regions { tank { source boxToPoint;"
            " box (-9 -9 -9) (9 9 9); lattice { rotation { type axisAngle;"
            " axis (0 0 1); angle 30; } } } }"
        )
    );

    t.check
    (
        fluid.size() == 16000,
        "tank turned by 30 degrees: " + text(fluid.size())
      + " of 16000 particles"
    );

    scalar nearest = GREAT;
    for (const point& p : fluid.position())
    {
        nearest = min(nearest, c.search.signedDistance(p));
    }
    t.check
    (
        mag(nearest - 0.5*dx) < 1e-6*dx,
        "turned tank: first row " + text(nearest/dx) + " dx off the walls"
    );
}


//- Places too near a wall that does not fit the lattice are moved, not left out
void offWalls(tally& t)
{
    testCase c("turned2D");
    const scalar dx = 0.01;

    fluidLattice fluid
    (
        c.mesh,
        c.search,
        parse
        (
            "dx 0.01; regions { tank { source boxToPoint;"
            " box (-9 -9 -9) (9 9 9); } }"
        )
    );

    scalar nearest = GREAT;
    for (const point& p : fluid.position())
    {
        nearest = min(nearest, c.search.signedDistance(p));
    }
    const scalar error = sum(fluid.volume())/1.6 - 1;
    t.check
    (
        mag(error) < 3e-3 && nearest > 0.9*0.25*dx,
        "turned tank, lattice not turned: error of area " + text(error)
      + ", nearest " + text(nearest/dx) + " dx off the walls"
    );
}


//- Jittered places stay near those of the lattice, spread evenly about them, and
//  come out the same each time
void jittered(tally& t)
{
    testCase c("box2D");
    const std::string column
    (
        "dx 0.01; regions { column { source boxToPoint;"
        " box (0 0 -9) (0.6 0.3 9); "
    );
    const fluidLattice lattice(c.mesh, c.search, parse(column + "} }"));
    const fluidLattice fluid(c.mesh, c.search, parse(column + "jitter 0.2; } }"));
    const fluidLattice again(c.mesh, c.search, parse(column + "jitter 0.2; } }"));

    vector mean(Zero), squares(Zero);
    scalar farthest = 0;
    forAll(fluid.position(), i)
    {
        const vector d((fluid.position()[i] - lattice.position()[i])/0.01);
        mean += d/fluid.size();
        squares += cmptMultiply(d, d)/fluid.size();
        farthest = max(farthest, cmptMax(cmptMag(d)));
    }
    t.check
    (
        fluid.size() == lattice.size()
     && fluid.position() == again.position()
     && farthest < 0.2 && cmptMax(cmptMag(mean)) < 0.01,
        "jitter: at most " + text(farthest) + " dx, mean " + text(cmptMax(mean))
    );

    // Of even spread over [-0.2, 0.2]: 0.2^2/3
    t.check
    (
        mag(squares.x() - 0.0133) < 1e-3 && mag(squares.y() - 0.0133) < 1e-3
     && squares.z() == 0,
        "jitter: mean squares " + text(squares.x()) + ", " + text(squares.y())
    );
}


void rings(tally& t)
{
    testCase c("box2D");

    fluidLattice fluid
    (
        c.mesh,
        c.search,
        parse
        (
            "dx 0.01; regions { drop { source cylinderToPoint;"
            " p1 (0.8 0.5 -1); p2 (0.8 0.5 1); radius 0.3;"
            " lattice { type concentric; centre (0.8 0.5 0); } } }"
        )
    );

    const scalar error =
        sum(fluid.volume())/(constant::mathematical::pi*sqr(0.3)) - 1;

    t.check
    (
        mag(error) < 1e-10,
        "drop of rings: " + text(fluid.size()) + " particles, error of area "
      + text(error)
    );

    const scalar gap = smallestGap(fluid.position(), 0.01)/0.01;
    t.check(gap > 0.7, "drop of rings: smallest distance " + text(gap) + " dx");
}


void box3D(tally& t)
{
    testCase c("box3D");

    fluidLattice fluid
    (
        c.mesh,
        c.search,
        parse
        (
            "dx 0.02; regions { all { source boxToPoint;"
            " box (-1 -1 -1) (1 1 1); } }"
        )
    );

    t.check
    (
        fluid.size() == 3000,
        "box in 3D: " + text(fluid.size()) + " of 3000 particles"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::fluidChecks(tally& t)
{
    column(t);
    fromField(t);
    turned(t);
    offWalls(t);
    jittered(t);
    rings(t);
    box3D(t);
}


// ************************************************************************* //
