/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallBodies.H"

#include "inputChecks.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelHashSet Foam::wallBodies::patchesOf
(
    const dictionary& body,
    const polyMesh& mesh,
    const labelHashSet& taken
) const
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const labelHashSet walls(patches.findPatchIDs<wallPolyPatch>());
    const auto names = [&](const labelHashSet& chosen)
    {
        wordList list;
        for (const label patchi : chosen.sortedToc())
        {
            list.append(patches[patchi].name());
        }
        return list;
    };

    const labelHashSet chosen
    (
        patches.patchSet(body.get<wordRes>("patches"), false)
    );
    labelHashSet others(chosen);
    others -= walls;
    if (chosen.empty() || others.size())
    {
        FatalIOErrorInFunction(entryPlace(body, "patches"))
            << (chosen.empty() ? "No patch" : "Not a wall but")
            << " is chosen by " << body.lookupEntry("patches", keyType::LITERAL)
            << "    " << names(others) << nl << nl
            << "Valid patches are" << nl << names(walls) << nl
            << exit(FatalIOError);
    }
    const labelHashSet twice(chosen & taken);
    if (twice.size())
    {
        FatalIOErrorInFunction(entryPlace(body, "patches"))
            << "Patches " << flatOutput(names(twice))
            << " belong to a body before." << nl
            << "    Choose each patch once: what moves in one way is one body."
            << exit(FatalIOError);
    }
    return chosen;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallBodies::wallBodies
(
    const dictionary& ulphProperties,
    const wallSearch& walls,
    const scalar dx
)
:
    dict_
    (
        ulphProperties.subOrEmptyDict("wallMotion").subOrEmptyDict("bodies")
    ),
    dx_(dx),
    bodies_(1 + dict_.size())
{
    if (dict_.empty())
    {
        bodies_.set(0, new wallBody(walls, dx));
        return;
    }

    const polyMesh& mesh = walls.mesh();
    labelHashSet moving;
    label next = 1;
    for (const word& name : dict_.toc())
    {
        const dictionary& entries = dict_.subDict(name);
        const labelHashSet patches(patchesOf(entries, mesh, moving));
        moving |= patches;
        bodies_.set
        (
            next++,
            new wallBody
            (
                mesh,
                [&](const polyPatch& pp) { return patches.found(pp.index()); },
                dx,
                autoPtr<solidBodyMotion>(new solidBodyMotion(entries, mesh, false))
            )
        );
    }
    // Other patches than walls do not count: they may bound a block that is there
    // for a piston to draw back into
    bodies_.set
    (
        0,
        new wallBody
        (
            mesh,
            [&](const polyPatch& pp)
            {
                return isA<wallPolyPatch>(pp) && !moving.found(pp.index());
            },
            dx,
            nullptr
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::wallBodies::hasWalls() const
{
    for (const wallBody& body : bodies_)
    {
        if (body.hasWalls())
        {
            return true;
        }
    }
    return false;
}


void Foam::wallBodies::setTime(const scalar t)
{
    for (wallBody& body : bodies_)
    {
        body.setTime(t);
    }
}


Foam::wallBodies::nearestWall Foam::wallBodies::nearest
(
    const point& p,
    const scalar maxDistance
) const
{
    nearestWall best{{maxDistance, vector::zero, p, -1}, 0};
    forAll(bodies_, i)
    {
        const wallBody& body = bodies_[i];
        const wallSearch::wallPoint found
        (
            body.nearestOnBody
            (
                body.now().toBody(p), min(maxDistance, mag(best.on.distance))
            )
        );
        if (found.found())
        {
            best = {found, i};
        }
    }
    return best;
}


void Foam::wallBodies::refuseDisplaced(const scalar t)
{
    setTime(t);
    const wallBody::placement asMeshed;
    for (label i = 1; i < size(); ++i)
    {
        if (bodies_[i].way(asMeshed) > 0.01*dx_)
        {
            const word name(dict_.toc()[i - 1]);
            FatalIOErrorInFunction(entryPlace(dict_, name))
                << "At time " << t << " s, when fluid is filled in, body " << name
                << " is " << bodies_[i].way(asMeshed)
                << " m from where the mesh has it." << nl
                << "    Give another time t0 at which its motion starts, or mesh"
                << " it where it starts."
                << exit(FatalIOError);
        }
    }
}


// ************************************************************************* //
