/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Rows of wallParticles in one tile, and the properties of a particle.

\*---------------------------------------------------------------------------*/

#include "wallParticles.H"
#include "pointGrid.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Particles of different rows keep this distance, over dx
constexpr scalar minGap = 0.7;

//- Sites nearer than this to each other are one, over dx
constexpr scalar samePlace = 1e-3;

//- Cosine of the angle between walls held to be square to each other
constexpr scalar square = 1e-3;

//- Site of a sheet that may become a particle
struct candidate
{
    wallSheets::site site;

    //- Is the sheet its nearest wall, rather than ending there?
    bool direct;
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wallParticles::tile& Foam::wallParticles::withRows(const tileKey& key)
{
    const auto place = made_.emplace(key, tile());

    if (place.second)
    {
        makeRows(key, place.first->second);
    }

    return place.first->second;
}


void Foam::wallParticles::makeRows(const tileKey& key, tile& t) const
{
    const boundarySurface& surface = search_.boundary();

    // Particles just outside take part in the contest for place
    boundBox bb(boxOf(key));
    bb.min() -= vector::uniform(dx_);
    bb.max() += vector::uniform(dx_);

    std::vector<candidate> candidates;
    std::vector<vector> planes;

    // Rows of plane walls fit together where these are square to each other
    const auto notePlane = [&](const label trianglei)
    {
        const label sheeti = sheets_.sheetOf(trianglei);

        if (sheeti < 0 || sheets_.isBent(sheeti)) return;

        const vector& normal = surface.normal(trianglei);
        scalar largest = 0;

        for (const vector& plane : planes)
        {
            largest = Foam::max(largest, mag(plane & normal));
        }

        if (largest < 1 - samePlace)
        {
            planes.push_back(normal);
            t.irregular = t.irregular || largest > square;
        }
    };

    sheets_.forSites
    (
        bb,
        [&](const wallSheets::site& s)
        {
            const scalar offset = (s.layer + 0.5)*dx_;
            const auto hit =
                surface.tree().nearest(s.position, sqr(3*nLayers*dx_));

            if (hit.triangle < 0) return;

            const scalar depth = -surface.signedDistance(s.position, hit);

            if (depth < 0.3*dx_) return;

            const std::vector<label> around = surface.around(hit);

            bool own = false, wall = false;
            for (const label i : around)
            {
                notePlane(i);
                own = own || sheets_.sheetOf(i) == s.sheet;
                wall = wall || sheets_.sheetOf(i) != wallSheets::notWall;
            }

            // Behind two walls at once
            const bool tie =
                wall && !s.extended && std::abs(depth - offset) < samePlace*dx_;

            if (!own && !tie) return;

            // Deeper than the next wall lets it: the rows of a tight bend
            if (depth < offset - 0.05*dx_) return;

            // Behind an opening in the wall: no farther in than past its ends
            if
            (
                !s.extended
             && sqr(depth) > sqr(1.04*offset) + sqr(nLayers*dx_)
            )
            {
                return;
            }

            candidates.push_back
            (
                {s, !s.extended && (tie || depth < 1.04*offset)}
            );
        }
    );

    std::stable_sort
    (
        candidates.begin(),
        candidates.end(),
        [](const candidate& a, const candidate& b)
        {
            return
                a.direct != b.direct ? a.direct
              : a.site.sheet < b.site.sheet;
        }
    );

    pointGrid grid(minGap*dx_);
    DynamicList<point> rows;
    DynamicList<scalar> volumes;

    for (const candidate& c : candidates)
    {
        // Also against those that lost: who lost must not depend on the tile
        const label other = grid.nearest(c.site.position);
        grid.append(c.site.position);

        if (other >= 0)
        {
            const scalar gap = mag(grid[other] - c.site.position);
            t.irregular = t.irregular || gap > samePlace*dx_;
        }
        else if (keyOf(c.site.position) == key)
        {
            rows.append(c.site.position);
            volumes.append(c.site.volume);
        }
    }

    t.rows = rows;
    t.rowVolumes = volumes;

    boundBox around(boxOf(key));
    around.min() -= vector::uniform(nLayers*dx_);
    around.max() += vector::uniform(nLayers*dx_);

    for (const label i : surface.tree().overlapping(around))
    {
        t.irregular = t.irregular || sheets_.sheetOf(i) == wallSheets::noSheet;
    }
}


void Foam::wallParticles::append
(
    const point& p,
    const scalar volume,
    wallParticleSet& set
) const
{
    const boundarySurface& surface = search_.boundary();
    const auto hit = surface.tree().nearest(p, GREAT);
    const scalar distance = std::sqrt(hit.distanceSqr);
    const vector outward((p - hit.position)/distance);

    label patch = -1, beyond = -1;
    std::vector<vector> mirrors;
    std::vector<label> sheetsMet;

    for (const label i : surface.around(hit))
    {
        const label sheeti = sheets_.sheetOf(i);

        if (sheeti == wallSheets::notWall)
        {
            beyond = Foam::max(beyond, surface.patch(i));
            continue;
        }

        if (patch < 0 || surface.patch(i) < patch) patch = surface.patch(i);

        // Bends within one wall mirror once, by the offset's direction
        if
        (
            std::find(sheetsMet.begin(), sheetsMet.end(), sheeti)
         == sheetsMet.end()
        )
        {
            sheetsMet.push_back(sheeti);
            mirrors.push_back(surface.normal(i));
        }
    }

    if (mirrors.size() == 1)
    {
        // Past the edge of a wall there is still only that wall to mirror
        if (beyond < 0 && !surface.onRim(hit)) mirrors[0] = outward;
    }

    symmTensor reflection(symmTensor::I);
    std::vector<vector> basis;

    for (vector n : mirrors)
    {
        for (const vector& b : basis)
        {
            n -= (n & b)*b;
        }

        if (mag(n) < 0.05) continue;

        basis.push_back(n/mag(n));
        reflection -= 2*sqr(basis.back());
    }

    set.position.append(p);
    set.volume.append(volume);
    set.distance.append(distance);
    set.normal.append(outward);
    set.reflection.append(reflection);
    set.patch.append(patch);
    set.beyond.append(beyond);
}


// ************************************************************************* //
