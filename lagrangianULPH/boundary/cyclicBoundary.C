/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicBoundary.H"
#include "cyclicPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "SubField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::cyclicBoundary::side Foam::cyclicBoundary::planeOf
(
    const cyclicPolyPatch& patch,
    const polyMesh& mesh
) const
{
    const scalar tolerance = 1e-6*mesh.bounds().mag();

    const vector area(gSum(patch.faceAreas()));
    const scalar size = gSum(mag(patch.faceAreas()));
    const point centre
    (
        gSum(pointField(patch.faceCentres()*mag(patch.faceAreas())))/size
    );

    const vector normal(area/mag(area));
    const scalar offset = centre & normal;

    bool plane = mag(area) > (1 - 1e-6)*size;
    for (const point& p : patch.localPoints())
    {
        plane = plane && mag((p & normal) - offset) < tolerance;
    }
    bool before = true;
    for (const point& p : mesh.points())
    {
        before = before && (p & normal) - offset < tolerance;
    }
    reduce(plane, andOp<bool>());
    reduce(before, andOp<bool>());
    if (!plane || !before)
    {
        FatalErrorInFunction
            << "Cyclic patch " << patch.name() << " of "
            << mesh.boundaryMesh().objectPath() << ' '
            << (plane ? "has parts of the mesh in front of it" : "is not plane")
            << '.' << nl
            << "    Particles repeat themselves between plane patches with the "
            << "whole mesh between them." << nl
            << "    Make the patch a wall or a patch, or choose another mesh"
            << exit(FatalError);
    }
    return {patch.name(), normal, offset, centre};
}


void Foam::cyclicBoundary::refuseSplit(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<processorCyclicPolyPatch>(patch))
        {
            const word& name =
                refCast<const processorCyclicPolyPatch>(patch).referPatchName();
            FatalErrorInFunction
                << "The decomposition has put the two sides of cyclic patch "
                << name << " of " << mesh.boundaryMesh().objectPath()
                << " on different processors." << nl
                << "    Keep them together in system/decomposeParDict: constraints "
                << "{ cyclics { type preservePatches; patches (" << name
                << "); } }, then decomposePar -force"
                << exit(FatalError);
        }
    }
}


void Foam::cyclicBoundary::addPair
(
    const cyclicPolyPatch& patch,
    const polyMesh& mesh
)
{
    side from(planeOf(patch, mesh));
    side to(planeOf(patch.neighbPatch(), mesh));

    const vector shift(to.shift - from.shift);
    if (mag(from.normal + to.normal) > 1e-6)
    {
        FatalErrorInFunction
            << "Cyclic patches " << from.patch << " and " << to.patch << " of "
            << mesh.boundaryMesh().objectPath() << " are not parallel." << nl
            << "    Particles repeat themselves by translation only: use "
            << "parallel patches, or walls and patches"
            << exit(FatalError);
    }
    from.shift = shift;
    to.shift = -shift;
    sides_.push_back(from);
    sides_.push_back(to);

    const std::vector<vector> before(translations_);
    for (const vector& s : {shift, vector(-shift)})
    {
        translations_.push_back(s);
        for (const vector& t : before)
        {
            translations_.push_back(t + s);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cyclicBoundary::cyclicBoundary(const polyMesh& mesh)
{
    refuseSplit(mesh);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            const cyclicPolyPatch& cyclic = refCast<const cyclicPolyPatch>(patch);
            if (cyclic.owner())
            {
                addPair(cyclic, mesh);
            }
        }
        else if (patch.coupled() && !isA<processorPolyPatch>(patch))
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of "
                << mesh.boundaryMesh().objectPath() << " is of type "
                << patch.type() << ", which particles cannot pass." << nl
                << "    Of the coupled types only cyclic is valid: rename it, "
                << "or make it a wall or a patch"
                << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::cyclicBoundary::past(const point& p) const
{
    scalar farthest = -GREAT;
    for (const side& s : sides_)
    {
        farthest = max(farthest, (p & s.normal) - s.offset);
    }
    return farthest;
}


Foam::point Foam::cyclicBoundary::wrapped(point p) const
{
    for (const side& s : sides_)
    {
        if ((p & s.normal) > s.offset)
        {
            p += s.shift;
        }
    }
    return p;
}


bool Foam::cyclicBoundary::holds(const point& p) const
{
    for (std::size_t i = 0; i < sides_.size(); ++i)
    {
        const scalar distance = (p & sides_[i].normal) - sides_[i].offset;
        if (i % 2 ? distance >= 0 : distance > 0)
        {
            return false;
        }
    }
    return true;
}


bool Foam::cyclicBoundary::repeats(const direction cmpt) const
{
    for (const side& s : sides_)
    {
        if (mag(s.normal[cmpt]) > SMALL)
        {
            return true;
        }
    }
    return false;
}


void Foam::cyclicBoundary::checkPeriods(const scalar shortest) const
{
    for (const side& s : sides_)
    {
        const scalar period = mag(s.shift & s.normal);
        if (period < shortest)
        {
            FatalErrorInFunction
                << "Cyclic patch " << s.patch << " is " << period
                << " m from the other of its pair, less than the " << shortest
                << " m over which particles see each other." << nl
                << "    Reduce dx, or let the mesh hold more periods"
                << exit(FatalError);
        }
    }
}


void Foam::cyclicBoundary::warnOfMisfit(const scalar dx) const
{
    for (const side& s : sides_)
    {
        const scalar spacings = mag(s.shift & s.normal)/dx;
        if (mag(spacings - std::round(spacings)) > 0.01)
        {
            WarningInFunction
                << "The period of cyclic patch " << s.patch << " is "
                << spacings << " particle spacings: the lattice has a seam "
                << "there." << nl
                << "    Choose dx as a whole fraction of the period" << nl
                << endl;
        }
    }
}


// ************************************************************************* //
