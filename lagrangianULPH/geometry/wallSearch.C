/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSearch.H"
#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallSearch::wallSearch(const polyMesh& mesh)
:
    wallSearch(mesh, [](const polyPatch&) { return true; })
{}


Foam::wallSearch::wallSearch
(
    const polyMesh& mesh,
    const std::function<bool(const polyPatch&)>& isChosen
)
:
    mesh_(mesh),
    boundary_
    (
        mesh,
        [&](const polyPatch& pp)
        {
            return
                isChosen(pp)
             && !isA<emptyPolyPatch>(pp)
             && !isA<processorPolyPatch>(pp);
        }
    ),
    walls_
    (
        mesh,
        [&](const polyPatch& pp)
        {
            return isChosen(pp) && isA<wallPolyPatch>(pp);
        }
    ),
    midPlane_(mesh.bounds().midpoint())
{
    if (mesh.nGeometricD() < 2)
    {
        FatalErrorInFunction
            << "The mesh has " << mesh.nGeometricD()
            << " space dimensions; particles need 2 (one pair of empty"
            << " patches) or 3 (none)" << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wallSearch::wallPoint Foam::wallSearch::nearest
(
    const point& p,
    const scalar maxDistance
) const
{
    // Distances are squared: keep clear of overflow
    const scalar reach = Foam::min(maxDistance, scalar(1e100));

    const triangleTree::hit h = walls_.tree().nearest(p, sqr(reach));

    if (h.triangle < 0)
    {
        return {maxDistance, vector::zero, p, -1};
    }

    wallPoint found;
    found.distance = walls_.signedDistance(p, h);
    found.position = h.position;
    found.patch = walls_.patch(h.triangle);

    // On the wall itself the offset has no direction
    const vector& pseudoNormal = walls_.pseudoNormal(h);
    found.normal =
        mag(found.distance) > 1e-10*mesh_.bounds().mag()
      ? (p - h.position)/found.distance
      : -pseudoNormal/mag(pseudoNormal);

    return found;
}


bool Foam::wallSearch::contains(const point& p) const
{
    if (!mesh_.bounds().contains(p))
    {
        return false;
    }

    const triangleTree::hit h = boundary_.tree().nearest(p, GREAT);

    // Without any boundary (fully periodic in parallel) the bounds decide
    return h.triangle < 0 || boundary_.signedDistance(p, h) > 0;
}


Foam::point Foam::wallSearch::onMidPlane(const point& p) const
{
    point moved(p);

    for (direction d = 0; d < 3; ++d)
    {
        if (mesh_.geometricD()[d] < 0)
        {
            moved[d] = midPlane_[d];
        }
    }

    return moved;
}


// ************************************************************************* //
