/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidLattice.H"
#include "initialField.H"
#include "inputChecks.H"
#include "particleLattice.H"
#include "pointGrid.H"
#include "Random.H"
#include "regionSelection.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Smallest distance to a wall, over dx
constexpr scalar wallGap = 0.25;

//- Particles of two regions nearer than this overlap, over dx
constexpr scalar regionGap = 0.9;

//- Components from -1 to 1 that follow from the place alone
vector randomVector(const point& place, const scalar dx)
{
    // Round-off must not choose others
    const vector rounded(1e3*place/dx);
    const FixedList<int64_t, 3> key
    ({
        std::llround(rounded.x()),
        std::llround(rounded.y()),
        std::llround(rounded.z())
    });
    Random random(label(Hasher(key.cdata(), sizeof(key)) >> 1));
    const vector first(random.sample01<vector>());
    return 2*first - vector::one;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::fluidLattice::spacing
(
    const dictionary& dict,
    const polyMesh& mesh
)
{
    if (!dict.found("dx"))
    {
        FatalIOErrorInFunction(dict)
            << "The particle spacing dx [m] is missing." << nl
            << "    Add for instance: dx 0.01;"
            << exit(FatalIOError);
    }

    const scalar dx = dict.get<scalar>("dx");

    if (!(dx > 0) || dx > GREAT)
    {
        FatalIOErrorInFunction(entryPlace(dict, "dx"))
            << "The particle spacing dx must be a length above zero [m], not "
            << dx << exit(FatalIOError);
    }

    const vector span(mesh.bounds().span());

    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.geometricD()[d] > 0 && dx > span[d])
        {
            FatalIOErrorInFunction(entryPlace(dict, "dx"))
                << "The particle spacing dx " << dx
                << " is larger than the mesh, whose sides are " << span
                << " m." << nl
                << "    Make dx a small fraction of the fluid's size, or"
                << " correct the scale of the mesh"
                << exit(FatalIOError);
        }
    }

    return dx;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fluidLattice::clearOfWalls(point& place) const
{
    const scalar gap = wallGap*dx_;
    const wallSearch::wallPoint wall(search_.nearest(place, gap));

    if (!wall.found()) return true;

    place += (gap - wall.distance)*wall.normal;

    return !search_.nearest(place, 0.9*gap).found();
}


void Foam::fluidLattice::fill(const dictionary& regionDict, const label regioni)
{
    // Those of its source stand beside them
    refuseMisspelt
    (
        regionDict,
        {
            "source", "sourceInfo", "field", "lattice", "jitter", "velocity",
            "pressure"
        }
    );

    const regionSelection region(mesh_, regionDict);
    const autoPtr<particleLattice> lattice =
        particleLattice::New(regionDict, search_, dx_);

    const scalar jitter =
        dx_*getInRange(regionDict, "jitter", 0, scalarMinMax(0, 0.5));

    const label start = size();
    label nHeld = 0, nInside = 0;

    lattice->forPlaces
    (
        [&](const pointField& places, const scalarField& volumes)
        {
            const boolList held(region.holds(places));

            forAll(places, i)
            {
                if (!held[i]) continue;
                ++nHeld;

                if (!search_.contains(places[i])) continue;
                ++nInside;

                point place(places[i]);
                if (jitter > 0)
                {
                    const point moved
                    (
                        search_.onMidPlane
                        (
                            place + jitter*randomVector(place, dx_)
                        )
                    );
                    if (search_.contains(moved)) place = moved;
                }

                if (!clearOfWalls(place)) continue;

                lattice_.append(places[i]);
                position_.append(place);
                volume_.append(volumes[i]);
            }
        }
    );

    const label n = size() - start;

    if (n < (1 << search_.nDims()))
    {
        FatalIOErrorInFunction(regionDict)
            << "Region " << regionNames_[regioni] << " gets " << n
            << " particles: it holds " << nHeld
            << " places of the lattice within the bounds of the mesh, of which "
            << nInside << " are inside the mesh and " << n
            << " clear of the walls." << nl
            << "    The mesh spans " << search_.bounds()
            << " m, the particle spacing dx is " << dx_ << " m." << nl
            << "    Correct the region's place and size (in 2D it must hold"
            << " the mid-plane), or reduce dx"
            << exit(FatalIOError);
    }

    checkOverlap(regionDict, regioni, start);

    const UList<point> own(&position_[start], n);
    const initialRegion known{mesh_.time(), own, dx_};

    velocity_.append
    (
        initialField<vector>::New("velocity", regionDict, known)->value(own)()
    );
    pressure_.append
    (
        initialField<scalar>::New("pressure", regionDict, known)->value(own)()
    );
    region_.append(labelList(n, regioni));

    Info<< "    " << regionNames_[regioni] << ": " << n << " particles" << endl;
}


void Foam::fluidLattice::checkOverlap
(
    const dictionary& regionDict,
    const label regioni,
    const label start
) const
{
    if (!start) return;

    pointGrid grid(regionGap*dx_);
    for (label i = 0; i < start; ++i)
    {
        grid.append(lattice_[i]);
    }

    for (label i = start; i < size(); ++i)
    {
        const label other = grid.nearest(lattice_[i]);

        if (other >= 0)
        {
            FatalIOErrorInFunction(regionDict)
                << "Regions " << regionNames_[region_[other]] << " and "
                << regionNames_[regioni] << " overlap at " << position_[i]
                << ": their particles there are "
                << mag(grid[other] - lattice_[i]) << " m apart, dx is "
                << dx_ << " m." << nl
                << "    Make the regions meet without overlap, on one lattice"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidLattice::fluidLattice
(
    const fvMesh& mesh,
    const wallSearch& search,
    const dictionary& dict
)
:
    mesh_(mesh),
    search_(search),
    dx_(spacing(dict, mesh))
{
    const dictionary& regions = dict.subDict("regions");

    DynamicList<word> names;
    for (const entry& e : regions)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(regions)
                << "Entry " << e.keyword() << " of regions is no dictionary."
                << nl << "    Write for instance: " << e.keyword()
                << " { source boxToPoint; box (0 0 0) (1 1 1); }"
                << exit(FatalIOError);
        }

        names.append(e.keyword());
    }
    regionNames_ = wordList(names);

    if (regionNames_.empty())
    {
        FatalIOErrorInFunction(regions)
            << "There is no region to fill with fluid." << nl
            << "    Add for instance: column { source boxToPoint;"
            << " box (0 0 0) (1 1 1); }"
            << exit(FatalIOError);
    }

    Info<< "Filling regions with particles, dx " << dx_ << " m" << endl;

    forAll(regionNames_, regioni)
    {
        fill(regions.subDict(regionNames_[regioni]), regioni);
    }
}


// ************************************************************************* //
