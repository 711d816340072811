/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Checks of packedLattice: outlines, volumes and distances of its particles.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "fluidLattice.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Largest distance of the outermost particles of a disc, by sectors of the
//- spacing, from where a smooth row has them
scalar roughness
(
    const UList<point>& points,
    const point& centre,
    const scalar radius,
    const scalar dx
)
{
    scalarField outermost(label(constant::mathematical::twoPi*radius/dx)/2, 0);
    for (const point& p : points)
    {
        const vector x(p - centre);
        const scalar turn =
            0.5 + std::atan2(x.y(), x.x())/constant::mathematical::twoPi;
        scalar& r = outermost[min(label(turn*outermost.size()), outermost.size() - 1)];
        r = max(r, std::hypot(x.x(), x.y()));
    }
    return max(mag(outermost - (radius - 0.5*dx)))/dx;
}


void packedDisc(tally& t)
{
    testCase c("box2D");
    const point centre(0.8, 0.5, 0.05);
    const scalar dx = 0.01;

    const auto disc = [&](const std::string& lattice)
    {
        return fluidLattice
        (
            c.mesh,
            c.search,
            parse
            (
                "dx 0.01; regions { drop { source cylinderToPoint;"
                " p1 (0.8 0.5 -1); p2 (0.8 0.5 1); radius 0.3;"
                " lattice { type " + lattice + "; } } }"
            )
        );
    };
    const fluidLattice square(disc("cartesian"));
    const fluidLattice packed(disc("packed"));

    t.check
    (
        packed.size() == square.size(),
        "packed disc: " + text(packed.size()) + " particles, as the squares"
    );

    const scalar error =
        sum(packed.volume())/(constant::mathematical::pi*sqr(0.3)) - 1;
    t.check
    (
        mag(error) < 1e-4 && max(packed.volume()) == min(packed.volume()),
        "packed disc: equal volumes, error of area " + text(error)
    );

    const scalar gap = smallestGap(packed.position(), dx)/dx;
    t.check(gap > 0.8, "packed disc: smallest distance " + text(gap) + " dx");

    const scalar rough = roughness(packed.position(), centre, 0.3, dx);
    const scalar before = roughness(square.position(), centre, 0.3, dx);
    t.check
    (
        rough < 0.2 && before > 2*rough,
        "packed disc: outline off by " + text(rough) + " dx, that of squares by "
      + text(before)
    );
}


void packedBox(tally& t)
{
    testCase c("box2D");

    // Squares that fill the box are at rest already
    fluidLattice fluid
    (
        c.mesh,
        c.search,
        parse
        (
            "dx 0.01; regions { column { source boxToPoint;"
            " box (0 0 -1) (0.6 0.3 1); lattice { type packed; } } }"
        )
    );

    scalar moved = 0;
    for (const point& p : fluid.position())
    {
        const vector cell(p/0.01);
        moved = max(moved, mag(cell.x() - std::floor(cell.x()) - 0.5));
        moved = max(moved, mag(cell.y() - std::floor(cell.y()) - 0.5));
    }
    t.check
    (
        fluid.size() == 1800 && moved < 0.05
     && mag(sum(fluid.volume()) - 0.18) < 1e-9,
        "packed column: moved by " + text(moved) + " dx, area "
      + text(sum(fluid.volume()))
    );
}


void packedBall(tally& t)
{
    testCase c("box3D");
    const boundBox bounds(c.search.bounds());
    const scalar dx = 0.02;
    const scalar radius = 0.3*cmptMin(bounds.span());
    const point m(bounds.midpoint());

    fluidLattice fluid
    (
        c.mesh,
        c.search,
        parse
        (
            "dx 0.02; regions { ball { source sphereToPoint; centre ("
          + text(m.x()) + ' ' + text(m.y()) + ' ' + text(m.z()) + "); radius "
          + text(radius) + "; lattice { type packed; } } }"
        )
    );

    const scalar error =
        sum(fluid.volume())/(4.0/3.0*constant::mathematical::pi*pow3(radius)) - 1;
    const scalar gap = smallestGap(fluid.position(), dx)/dx;
    t.check
    (
        mag(error) < 5e-3 && gap > 0.7,
        "packed ball: " + text(fluid.size()) + " particles, error of volume "
      + text(error) + ", smallest distance " + text(gap) + " dx"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::packedChecks(tally& t)
{
    packedDisc(t);
    packedBox(t);
    packedBall(t);
}


// ************************************************************************* //
