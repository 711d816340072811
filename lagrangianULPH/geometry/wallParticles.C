/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallParticles.H"
#include <algorithm>
#include <cmath>
#include <set>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wallParticles::tileKey Foam::wallParticles::keyOf(const point& p) const
{
    tileKey key{0, 0, 0};

    for (direction d = 0; d < 3; ++d)
    {
        if (ring(d))
        {
            key[d] = label(std::floor((p[d] - origin_[d])/(tileSide*dx_)));
        }
    }

    return key;
}


Foam::boundBox Foam::wallParticles::boxOf(const tileKey& key) const
{
    boundBox bb(search_.bounds());

    for (direction d = 0; d < 3; ++d)
    {
        if (ring(d))
        {
            bb.min()[d] = origin_[d] + key[d]*tileSide*dx_;
            bb.max()[d] = origin_[d] + (key[d] + 1)*tileSide*dx_;
        }
    }

    return bb;
}


Foam::label Foam::wallParticles::ring(const direction cmpt) const
{
    return search_.mesh().geometricD()[cmpt] > 0;
}


void Foam::wallParticles::forNeighbours
(
    const tileKey& key,
    const std::function<void(const tileKey&)>& visit
) const
{
    for (label i = -ring(0); i <= ring(0); ++i)
    for (label j = -ring(1); j <= ring(1); ++j)
    for (label k = -ring(2); k <= ring(2); ++k)
    {
        if (i || j || k)
        {
            visit({key[0] + i, key[1] + j, key[2] + k});
        }
    }
}


void Foam::wallParticles::findTiles()
{
    const boundarySurface& surface = search_.boundary();
    const pointField& points = surface.tree().points();

    // The corner where three walls meet is farthest
    const scalar reach = std::sqrt(scalar(3))*nLayers*dx_;
    const scalar halfTile = 0.5*std::sqrt(scalar(3))*tileSide*dx_;

    std::set<tileKey> near, far;

    for (label i = 0; i < surface.size(); ++i)
    {
        if (sheets_.sheetOf(i) == wallSheets::notWall) continue;

        boundBox bb;
        for (const label pointi : surface.tree().triangles()[i])
        {
            bb.add(points[pointi]);
        }

        const tileKey low = keyOf(bb.min() - vector::uniform(reach));
        const tileKey high = keyOf(bb.max() + vector::uniform(reach));

        for (label x = low[0]; x <= high[0]; ++x)
        for (label y = low[1]; y <= high[1]; ++y)
        for (label z = low[2]; z <= high[2]; ++z)
        {
            const tileKey key{x, y, z};

            if (near.count(key) || far.count(key)) continue;

            const point centre(search_.onMidPlane(boxOf(key).midpoint()));
            const auto hit =
                surface.tree().nearest(centre, sqr(reach + halfTile));

            // Tiles wholly inside the fluid hold nothing
            const bool empty =
                hit.triangle < 0
             || surface.signedDistance(centre, hit) > halfTile;

            (empty ? far : near).insert(key);
        }
    }

    tiles_.assign(near.begin(), near.end());
}


const Foam::wallParticleSet& Foam::wallParticles::complete(const tileKey& key)
{
    tile& t = withFill(key);

    if (!t.complete)
    {
        scalarField volumes(t.rows.size() + t.fill.size());

        forAll(volumes, i)
        {
            volumes[i] =
                i < t.rows.size()
              ? t.rowVolumes[i]
              : std::pow(dx_, search_.nDims());
        }

        if (t.irregular)
        {
            shareVolumes(key, t, volumes);
        }

        forAll(volumes, i)
        {
            append
            (
                i < t.rows.size() ? t.rows[i] : t.fill[i - t.rows.size()],
                volumes[i],
                t.set
            );
        }

        t.complete = true;
    }

    return t.set;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallParticles::wallParticles
(
    const wallSearch& search,
    const scalar dx
)
:
    search_(search),
    dx_(dx),
    sheets_(search, dx, nLayers),

    // Off the lattices that start from the mesh corner
    origin_(search.bounds().min() + vector(0.271, 0.229, 0.257)*dx)
{
    findTiles();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::wallParticles::update(const needed& isNeeded)
{
    std::vector<tileKey> wanted;

    for (const tileKey& key : tiles_)
    {
        if (isNeeded(boxOf(key))) wanted.push_back(key);
    }

    if (wanted == activeTiles_)
    {
        return false;
    }

    activeTiles_ = std::move(wanted);
    active_.clear();

    for (const tileKey& key : activeTiles_)
    {
        active_.append(complete(key));
    }

    return true;
}


bool Foam::wallParticles::update
(
    const UList<point>& fluid,
    const scalar reach
)
{
    // Bounds of the points in each tile
    std::map<tileKey, boundBox> occupied;
    tileKey latest{0, 0, 0};
    boundBox* box = nullptr;

    for (const point& p : fluid)
    {
        const tileKey key = keyOf(p);

        // Points come in spatial order: mostly the tile of the one before
        if (!box || key != latest)
        {
            box = &occupied[key];
            latest = key;
        }

        box->add(p);
    }

    const label nRings = label(std::ceil(reach/(tileSide*dx_)));

    return update
    (
        [&](const boundBox& bb)
        {
            const tileKey key = keyOf(bb.midpoint());

            for (label i = -nRings*ring(0); i <= nRings*ring(0); ++i)
            for (label j = -nRings*ring(1); j <= nRings*ring(1); ++j)
            for (label k = -nRings*ring(2); k <= nRings*ring(2); ++k)
            {
                const auto place =
                    occupied.find({key[0] + i, key[1] + j, key[2] + k});

                if (place == occupied.end()) continue;

                const vector gap
                (
                    Foam::max
                    (
                        Foam::max
                        (
                            place->second.min() - bb.max(),
                            bb.min() - place->second.max()
                        ),
                        vector::zero
                    )
                );

                if (magSqr(gap) <= sqr(reach)) return true;
            }

            return false;
        }
    );
}


// ************************************************************************* //
