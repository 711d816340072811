/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Single wall particles in the holes between the rows of wallParticles.

    Tiles are filled in the order of their colour (8 colours in 3D, 4 in 2D;
    neighbours differ), each seeing its neighbours of lower colour, whichever
    tile is asked for first.

\*---------------------------------------------------------------------------*/

#include "wallParticles.H"
#include "pointGrid.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A place farther than this from every particle is a hole, over dx:
//- above the half-diagonal of the undisturbed lattice
constexpr scalar holeSize2D = 0.8;
constexpr scalar holeSize3D = 0.92;

//- Places looked at per dx and direction
constexpr label nLooks = 3;

inline label colour(const std::array<label, 3>& key)
{
    return (key[0] & 1) + 2*(key[1] & 1) + 4*(key[2] & 1);
}

//- Place to be looked at
struct look
{
    label layer;

    point position;
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wallParticles::tile& Foam::wallParticles::withFill(const tileKey& key)
{
    tile& t = withRows(key);

    if (!t.filled)
    {
        // Set first: colours rise along every chain of calls
        t.filled = true;

        if (t.irregular) makeFill(key, t);
    }

    return t;
}


void Foam::wallParticles::makeFill(const tileKey& key, tile& t)
{
    const boundarySurface& surface = search_.boundary();
    const bool planar = search_.nDims() == 2;

    pointGrid grid((planar ? holeSize2D : holeSize3D)*dx_);

    const auto add = [&](const pointField& points)
    {
        for (const point& p : points) grid.append(p);
    };

    add(t.rows);

    forNeighbours
    (
        key,
        [&](const tileKey& other)
        {
            const tile& n =
                colour(other) < colour(key) ? withFill(other) : withRows(other);

            add(n.rows);

            if (colour(other) < colour(key)) add(n.fill);
        }
    );

    std::vector<look> looks;
    const boundBox bb(boxOf(key));
    const label n = tileSide*nLooks;
    const scalar step = dx_/nLooks;

    for (label i = 0; i < (ring(0) ? n : 1); ++i)
    for (label j = 0; j < (ring(1) ? n : 1); ++j)
    for (label k = 0; k < (ring(2) ? n : 1); ++k)
    {
        const point place
        (
            search_.onMidPlane
            (
                bb.min() + step*vector(i + 0.5, j + 0.5, k + 0.5)
            )
        );

        // Holes are rare: look for particles first, walls after
        if (!planar && grid.any(place)) continue;

        const auto hit =
            surface.tree().nearest(place, sqr(nLayers*dx_));

        if (hit.triangle < 0) continue;

        const scalar depth = -surface.signedDistance(place, hit);

        if (depth < step) continue;

        bool wall = false;
        for (const label trianglei : surface.around(hit))
        {
            wall = wall || sheets_.sheetOf(trianglei) != wallSheets::notWall;
        }

        if (!wall) continue;

        // Onto the layer, where that does not leave the tile
        const label layer = label(depth/dx_);
        const point p
        (
            hit.position
          + (layer + 0.5)*dx_/depth*(place - hit.position)
        );

        if (keyOf(p) == key && !grid.any(p))
        {
            looks.push_back({layer, p});
        }
    }

    std::stable_sort
    (
        looks.begin(),
        looks.end(),
        [](const look& a, const look& b) { return a.layer < b.layer; }
    );

    DynamicList<point> fill;

    for (const look& l : looks)
    {
        if (!grid.any(l.position))
        {
            grid.append(l.position);
            fill.append(l.position);
        }
    }

    t.fill = fill;
}


// ************************************************************************* //
