/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Checks of wallSearch and cellLocator against brute force.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "cellLocator.H"
#include "tetIndices.H"
#include "triPointRef.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

void nearestWall(tally& t, const word& name)
{
    testCase c(name);
    const polyBoundaryMesh& patches = c.mesh.boundaryMesh();

    scalar error = 0;
    label wrongSide = 0, wrongInside = 0, n = 0;

    for (const point& p : c.randomPoints(2000, 0.1))
    {
        scalar distance = GREAT;

        for (const polyPatch& pp : patches)
        {
            if (!isA<wallPolyPatch>(pp)) continue;

            for (const face& f : pp)
            {
                faceList triangles(f.nTriangles());
                label n = 0;
                f.triangles(c.mesh.points(), n, triangles);

                for (const face& tri : triangles)
                {
                    distance = min
                    (
                        distance,
                        triPointRef
                        (
                            c.mesh.points()[tri[0]],
                            c.mesh.points()[tri[1]],
                            c.mesh.points()[tri[2]]
                        ).nearestPoint(p).distance()
                    );
                }
            }
        }

        const wallSearch::wallPoint found = c.search.nearest(p);
        error = max(error, mag(mag(found.distance) - distance));
        error =
            max
            (
                error,
                mag(found.position + found.distance*found.normal - p)
            );

        // Cells and boundary triangles split warped faces differently
        if (distance < 1e-3) continue;

        const bool inside = c.mesh.findCell(p) >= 0;
        wrongSide += (found.distance > 0) != inside;
        wrongInside += c.search.contains(p) != inside;
        ++n;
    }

    t.check
    (
        error < 1e-9,
        name + ": distance and normal of the nearest wall, error " + text(error)
    );
    t.check
    (
        wrongSide == 0 && wrongInside == 0,
        name + ": side of the wall wrong for " + text(wrongSide)
      + ", inside wrong for " + text(wrongInside) + " of " + text(n)
      + " points"
    );
}


void location(tally& t, const word& name)
{
    testCase c(name);
    const cellLocator locator(c.mesh);
    const pointField points(c.randomPoints(2000, 0.02));
    const labelList cells(locator.find(points));

    label wrong = 0;
    scalar error = 0;

    forAll(points, i)
    {
        const point& p = points[i];

        if (mag(c.search.signedDistance(p)) < 1e-3) continue;

        const bool inside = c.mesh.findCell(p) >= 0;

        if (inside != (cells[i] >= 0))
        {
            ++wrong;
            continue;
        }

        if (!inside) continue;

        const cellLocator::tetPlace place = locator.place(p, cells[i]);
        const tetIndices tet(cells[i], place.tetFace, place.tetPt);

        error =
            max
            (
                error,
                mag
                (
                    tet.tet(c.mesh).barycentricToPoint(place.coordinates) - p
                )
            );
        error = max(error, -cmptMin(place.coordinates) - 1e-3);
    }

    t.check
    (
        wrong == 0 && error < 1e-9,
        name + ": cells of points, " + text(wrong)
      + " wrong, error of the place in the cell " + text(error)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::searchChecks(tally& t)
{
    for (const word name : {"turned2D", "step2D", "cylinder2D", "sphere3D"})
    {
        nearestWall(t, name);
        location(t, name);
    }
}


// ************************************************************************* //
