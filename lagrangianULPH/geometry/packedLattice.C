/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "packedLattice.H"
#include "inputChecks.H"
#include "pointGrid.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace particleLattices
{
    defineTypeNameAndDebug(packed, 0);
    addToRunTimeSelectionTable(particleLattice, packed, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Radius of the kernel, over dx
constexpr Foam::scalar reach = 3;

//- Farther than that are neighbours listed, over dx; half of it is what two
//- particles may move before new lists
constexpr Foam::scalar slack = 0.4;

//- Moves per unit of the kernel sum, and the largest one, over dx
constexpr Foam::scalar stiffness = 0.2;
constexpr Foam::scalar largestMove = 0.1;

//- Cells per dx outside, and parts of those at the surface, in each direction
constexpr Foam::label cellsPerSpacing = 2;
constexpr Foam::label parts = 4;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::particleLattices::packed::inside
(
    const pointField& points
) const
{
    boolList held(region_.holds(points));
    forAll(held, i)
    {
        held[i] = held[i] && search_.contains(points[i]);
    }
    return held;
}


Foam::pointField Foam::particleLattices::packed::startPlaces() const
{
    DynamicList<point> places;
    start_->forPlaces([&](const pointField& some, const scalarField&)
    {
        const boolList held(inside(some));
        forAll(some, i)
        {
            if (held[i]) places.append(some[i]);
        }
    });
    return pointField(places);
}


Foam::pointField Foam::particleLattices::packed::cells
(
    const boundBox& box,
    const scalar side,
    labelVector& n
) const
{
    for (direction d = 0; d < 3; ++d)
    {
        n[d] =
            search_.mesh().geometricD()[d] < 0
          ? 1
          : max(label(1), label(std::lround(box.span()[d]/side)));
    }

    pointField centres(n.x()*n.y()*n.z());
    forAll(centres, c)
    {
        const vector steps
        (
            c % n.x() + 0.5,
            c / n.x() % n.y() + 0.5,
            c / (n.x()*n.y()) + 0.5
        );
        centres[c] = search_.onMidPlane(box.min() + side*steps);
    }
    return centres;
}


Foam::scalar Foam::particleLattices::packed::findOutside
(
    const boundBox& box,
    weights& outside
) const
{
    const scalar side = dx_/cellsPerSpacing;
    const scalar volume = std::pow(scalar(cellsPerSpacing), -search_.nDims());

    labelVector n;
    const pointField centres(cells(box, side, n));
    const boolList held(inside(centres));
    const label strides[] = {1, n.x(), n.x()*n.y()};

    // Cells with a neighbour of the other kind are at the surface
    boolList cut(held);
    cut = false;
    forAll(centres, c)
    {
        for (direction d = 0; d < 3; ++d)
        {
            const label next = c + strides[d];
            if (c/strides[d] % n[d] + 1 < n[d] && held[c] != held[next])
            {
                cut[c] = cut[next] = true;
            }
        }
    }

    const vector half(vector::uniform(0.5*side));
    const label nParts = label(std::pow(scalar(parts), search_.nDims()) + 0.5);
    scalar total = 0;
    DynamicList<point> cutUp;
    forAll(centres, c)
    {
        if (cut[c])
        {
            labelVector nCut;
            cutUp.append
            (
                cells
                (
                    boundBox(centres[c] - half, centres[c] + half),
                    side/parts,
                    nCut
                )
            );
        }
        else if (held[c])
        {
            total += volume;
        }
        else
        {
            outside.append(centres[c], volume);
        }
    }

    const pointField partCentres(std::move(cutUp));
    const boolList heldParts(inside(partCentres));
    for (label first = 0; first < partCentres.size(); first += nParts)
    {
        point sum(Zero);
        label nOut = 0;
        for (label i = first; i < first + nParts; ++i)
        {
            if (!heldParts[i])
            {
                sum += partCentres[i];
                ++nOut;
            }
        }
        total += volume*(nParts - nOut)/nParts;
        if (nOut)
        {
            outside.append(sum/nOut, volume*nOut/nParts);
        }
    }
    return total;
}


std::vector<std::vector<Foam::label>> Foam::particleLattices::packed::neighbours
(
    const pointField& places,
    const weights& outside
) const
{
    pointGrid grid((reach + slack)*dx_);
    for (const point& p : places) grid.append(p);
    for (const point& p : outside.x) grid.append(p);

    std::vector<std::vector<label>> lists(places.size());

    #pragma omp parallel for schedule(dynamic, 64)
    for (label i = 0; i < places.size(); ++i)
    {
        grid.near(places[i], [&](const label j, scalar)
        {
            if (j != i) lists[i].push_back(j);
            return true;
        });
        std::sort(lists[i].begin(), lists[i].end());
    }
    return lists;
}


Foam::scalar Foam::particleLattices::packed::relax
(
    const std::vector<std::vector<label>>& neighbours,
    const weights& outside,
    const scalar volume,
    pointField& places
) const
{
    const label n = places.size();
    pointField moved(places);
    scalar largest = 0;

    #pragma omp parallel for schedule(static) reduction(max : largest)
    for (label i = 0; i < n; ++i)
    {
        vector sum(Zero);
        for (const label j : neighbours[i])
        {
            const vector x((j < n ? places[j] : outside.x[j - n]) - places[i]);
            const scalar r = mag(x);
            const scalar q = r/(reach*dx_);
            if (q < 1 && q > SMALL)
            {
                sum +=
                    pow4(1 - q)*(1 + 4*q)/r
                   *(j < n ? volume : outside.V[j - n])*x;
            }
        }
        const scalar move = min(stiffness*mag(sum), largestMove);
        moved[i] -= dx_*move*sum/max(mag(sum), VSMALL);
        largest = max(largest, move);
    }
    places = moved;
    return largest;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleLattices::packed::packed
(
    const dictionary& dict,
    const wallSearch& search,
    const scalar dx
)
:
    particleLattice(search, dx),
    region_(refCast<const fvMesh>(search.mesh()), dict.parent()),
    start_(particleLattice::New(dict, search, dx, "start")),
    maxIterations_
    (
        dict.getCheckOrDefault<label>("iterations", 400, labelMinMax::ge(0))
    ),
    tolerance_(getInRange(dict, "tolerance", 0.002, scalarMinMax::ge(0)))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleLattices::packed::forPlaces(const receiver& take) const
{
    const pointField start(startPlaces());
    if (start.empty())
    {
        return;
    }

    boundBox box(start);
    const vector margin(vector::uniform((reach + 1)*dx_));
    box = boundBox(box.min() - margin, box.max() + margin);
    weights outside;
    const scalar volume = findOutside(box, outside)/start.size();

    pointField places(start);
    std::vector<std::vector<label>> lists;
    scalar largest = GREAT;
    scalar sinceLists = GREAT;
    label iteration = 0;

    for (; iteration < maxIterations_ && largest > tolerance_; ++iteration)
    {
        if (sinceLists > 0.5*slack)
        {
            lists = neighbours(places, outside);
            sinceLists = 0;
        }
        largest = relax(lists, outside, volume, places);
        sinceLists += largest;
    }

    // A corner too narrow for the kernel may have pressed some out
    const boolList held(inside(places));
    label nBack = 0;
    forAll(places, i)
    {
        if (!held[i])
        {
            places[i] = start[i];
            ++nBack;
        }
    }
    Info<< "    packed in " << iteration << " iterations, last move "
        << largest << " dx, " << nBack << " left in place, volume of a particle "
        << volume << " dx^" << search_.nDims() << endl;

    take
    (
        places,
        scalarField(places.size(), volume*std::pow(dx_, search_.nDims()))
    );
}


// ************************************************************************* //
