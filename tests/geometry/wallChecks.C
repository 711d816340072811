/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Checks of wallParticles behind plane walls: numbers and places, holes,
    properties, and independence of the order of requests.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "fluidLattice.H"
#include "pointGrid.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Sum of V W over all particles of the support, less the lattice's own
void checkSums
(
    tally& t,
    const std::string& name,
    const testCase& c,
    const UList<point>& fluid,
    const wallParticleSet& walls,
    const scalar dx
)
{
    const label nDims = c.search.nDims();
    const scalar volume = std::pow(dx, nDims);

    pointGrid grid(4*dx);
    for (const point& p : fluid) grid.append(p);
    for (const point& p : walls.position) grid.append(p);

    scalar exact = 0;
    for (label i = -4; i <= 4; ++i)
    for (label j = -4; j <= 4; ++j)
    for (label k = nDims == 2 ? 0 : -4; k <= (nDims == 2 ? 0 : 4); ++k)
    {
        exact += volume*kernel(dx*mag(vector(i, j, k)), dx, nDims);
    }

    scalar error = 0;
    for (const point& p : fluid)
    {
        scalar sum = 0;
        grid.near
        (
            p,
            [&](const label i, const scalar dSqr)
            {
                const label w = i - fluid.size();
                sum +=
                    (w < 0 ? volume : walls.volume[w])
                   *kernel(std::sqrt(dSqr), dx, nDims);
                return true;
            }
        );
        error = max(error, mag(sum - exact));
    }

    t.check
    (
        error < 1e-6,
        name + ": kernel sums of the full tank, largest error " + text(error)
    );
}


void checkGap
(
    tally& t,
    const std::string& name,
    const wallParticleSet& walls,
    const scalar dx
)
{
    pointGrid grid(1.5*dx);
    scalar gap = GREAT;

    for (const point& p : walls.position)
    {
        const label other = grid.nearest(p);
        if (other >= 0) gap = min(gap, mag(grid[other] - p));
        grid.append(p);
    }

    t.check
    (
        mag(gap/dx - 1) < 1e-6,
        name + ": smallest distance of wall particles " + text(gap/dx) + " dx"
    );
}


//- Tanks that lattice and walls fill without a gap
void filled
(
    tally& t,
    const word& name,
    const scalar dx,
    const label nFluid,
    const label nWall,
    const std::string& lattice = ""
)
{
    testCase c(name);

    fluidLattice fluid
    (
        c.mesh,
        c.search,
        parse
        (
            "dx " + text(dx) + "; regions { all { source boxToPoint;"
            " box (-9 -9 -9) (9 9 9); " + lattice + "} }"
        )
    );
    const wallParticleSet walls(c.allWalls(dx));

    t.check
    (
        fluid.size() == nFluid && walls.size() == nWall,
        name + ": " + text(fluid.size()) + " fluid and " + text(walls.size())
      + " wall particles of " + text(nFluid) + " and " + text(nWall)
    );
    checkGap(t, name, walls, dx);
    checkSums(t, name, c, fluid.position(), walls, dx);
}


void properties(tally& t)
{
    testCase c("box2D");
    const wallParticleSet walls(c.allWalls(0.01));

    scalar error = 0;
    bool patches = true;

    for (label i = 0; i < walls.size(); ++i)
    {
        const point& p = walls.position[i];

        // Walls the particle is behind
        const vector behind
        (
            p.x() < 0 || p.x() > 1.6,
            p.y() < 0 || p.y() > 1,
            0
        );
        const symmTensor expected
        (
            1 - 2*behind.x(), 0, 0,
            1 - 2*behind.y(), 0,
            1
        );

        error =
            max(error, mag(walls.reflection[i] - expected));

        const point onWall(p - walls.distance[i]*walls.normal[i]);
        error = max(error, mag(c.search.signedDistance(onWall))/0.01);

        patches =
            patches && walls.beyond[i] == -1
         && walls.patch[i] == (p.y() > 1 && !behind.x());
    }

    t.check(error < 1e-9, "box2D: reflection and normal, error " + text(error));
    t.check(patches, "box2D: patches of the wall particles");
}


//- Walls go on straight past inlet and outlet, and nothing is behind these
void openEnds(tally& t)
{
    testCase c("channel2D");
    const wallParticleSet walls(c.allWalls(0.01));

    bool place = true, beyond = true, reflection = true;

    for (label i = 0; i < walls.size(); ++i)
    {
        const point& p = walls.position[i];

        place = place && p.y() < 0 && p.x() > -0.05 && p.x() < 1.05;
        beyond =
            beyond && walls.patch[i] == 2
         && walls.beyond[i] == (p.x() < 0 ? 0 : p.x() > 1 ? 1 : -1);
        reflection =
            reflection
         && mag(walls.reflection[i] - symmTensor(1, 0, 0, -1, 0, 1)) < 1e-9;
    }

    t.check
    (
        walls.size() == 550 && place,
        "channel2D: " + text(walls.size()) + " of 550 wall particles"
    );
    t.check(beyond, "channel2D: patches past whose edges particles lie");
    t.check(reflection, "channel2D: reflection in the one wall only");
}


//- Same particles and order, however they have been asked for
void independence(tally& t, const word& name, const scalar dx)
{
    testCase c(name);
    const wallParticleSet once(c.allWalls(dx));

    // Slice after slice, backwards
    wallParticles walls(c.search, dx);
    const boundBox& bounds = c.search.bounds();
    const label n = 7;

    for (label slice = n; slice >= 0; --slice)
    {
        const scalar x =
            bounds.min().x() + (slice + 0.5)/n*bounds.span().x();

        walls.update
        (
            [&](const boundBox& bb)
            {
                return bb.min().x() < x + 5*dx && bb.max().x() > x - 5*dx;
            }
        );
    }
    const label nPart = walls.active().size();
    walls.update([](const boundBox&) { return true; });

    t.check
    (
        nPart < once.size() && walls.active().position == once.position
     && walls.active().volume == once.volume,
        name + ": " + text(once.size())
      + " wall particles the same when asked for in another order"
    );

    const bool again = walls.update([](const boundBox&) { return true; });
    t.check(!again, name + ": same request, nothing changed");
}


void nearFluid(tally& t)
{
    testCase c("box2D");
    const scalar dx = 0.01;
    const wallParticleSet all(c.allWalls(dx));
    const pointField fluid(1, point(0.3, 0.1, 0.05));

    wallParticles walls(c.search, dx);
    walls.update(fluid, 5*dx);
    const label nFar = walls.active().size();

    walls.update(pointField(1, point(0.3, 0.005, 0.05)), 5*dx);
    const wallParticleSet& near = walls.active();

    label missing = 0;
    for (const point& p : all.position)
    {
        bool found = mag(p - point(0.3, 0.005, 0.05)) > 5*dx;
        for (const point& q : near.position) found = found || p == q;
        missing += !found;
    }

    t.check
    (
        nFar == 0 && missing == 0 && near.size() < 200,
        "box2D: one fluid particle calls for " + text(near.size())
      + " wall particles, " + text(missing) + " missing"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::wallChecks(tally& t)
{
    filled(t, "box2D", 0.01, 16000, 2700);
    filled
    (
        t, "turned2D", 0.01, 16000, 2700,
        "lattice { rotation { type axisAngle; axis (0 0 1); angle 30; } }"
    );
    filled(t, "step2D", 0.01, 15000, 3100);
    filled(t, "box3D", 0.02, 3000, 12000);

    properties(t);
    openEnds(t);
    independence(t, "step2D", 0.013);
    independence(t, "cylinder2D", 0.01);
    independence(t, "sphere3D", 0.025);
    nearFluid(t);
}


// ************************************************************************* //
