/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Volumes of wallParticles around filled holes: each gets the space nearer
    to it than to any other, counted on a fine lattice.

\*---------------------------------------------------------------------------*/

#include "wallParticles.H"
#include "pointGrid.H"
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Farthest a place may be from the particle it belongs to, over dx
constexpr scalar volumeReach = 1.2;

//- Particles nearer than this to a filled hole are not in undisturbed rows
constexpr scalar disturbed = 1.5;

//- No fluid particle sees farther into the wall than this, over dx
constexpr scalar visible = 4.2;

//- Places counted per dx and direction
constexpr label nCounts = 3;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::wallParticles::shareVolumes
(
    const tileKey& key,
    const tile& t,
    scalarField& volumes
)
{
    const boundarySurface& surface = search_.boundary();

    // Own particles come first, so that their indices are those of volumes
    pointGrid all(volumeReach*dx_);
    pointGrid holes(disturbed*dx_);

    const auto add = [&](const tile& from)
    {
        for (const point& p : from.rows) all.append(p);
        for (const point& p : from.fill)
        {
            all.append(p);
            holes.append(p);
        }
    };

    add(t);
    forNeighbours(key, [&](const tileKey& other) { add(withFill(other)); });

    if (!holes.size()) return;

    // A whole dx beyond the tile on each side
    const boundBox bb(boxOf(key));
    const label n = (tileSide + 2)*nCounts;
    const scalar step = dx_/nCounts;
    labelList counts(volumes.size(), 0);

    for (label i = 0; i < (ring(0) ? n : 1); ++i)
    for (label j = 0; j < (ring(1) ? n : 1); ++j)
    for (label k = 0; k < (ring(2) ? n : 1); ++k)
    {
        const point place
        (
            search_.onMidPlane
            (
                bb.min()
              + step*vector(i + 0.5, j + 0.5, k + 0.5)
              - vector::uniform(dx_)
            )
        );

        const label owner = all.nearest(place);

        if (owner < 0 || owner >= counts.size()) continue;

        const auto hit = surface.tree().nearest(place, sqr(nLayers*dx_));

        if (hit.triangle >= 0 && surface.signedDistance(place, hit) < 0)
        {
            ++counts[owner];
        }
    }

    const scalar share = std::pow(step, search_.nDims());

    forAll(volumes, i)
    {
        if
        (
            counts[i]
         && holes.any(all[i])
         && surface.tree().nearest(all[i], sqr(visible*dx_)).triangle >= 0
        )
        {
            volumes[i] = counts[i]*share;
        }
    }
}


// ************************************************************************* //
