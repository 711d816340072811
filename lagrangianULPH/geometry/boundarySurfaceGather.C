/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Collection of the boundary triangles of all processors.

\*---------------------------------------------------------------------------*/

#include "boundarySurface.H"
#include "joinProcessors.H"
#include "pointGrid.H"
#include "polyMesh.H"
#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::boundarySurface::gather
(
    const polyMesh& mesh,
    const std::function<bool(const polyPatch&)>& isChosen,
    pointField& corners
)
{
    DynamicList<point> ownCorners;
    DynamicList<label> ownPatch;

    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!isChosen(pp)) continue;

        forAll(pp, facei)
        {
            const face& f = pp[facei];

            faceList tris(f.nTriangles());
            label trianglei = 0;
            f.triangles(mesh.points(), trianglei, tris);

            for (const face& tri : tris)
            {
                // Slivers would have no normal
                if (tri.mag(mesh.points()) < VSMALL) continue;

                for (const label pointi : tri)
                {
                    ownCorners.append(mesh.points()[pointi]);
                }
                ownPatch.append(pp.index());
            }
        }
    }

    const List<point> allCorners(joinProcessors(ownCorners));
    const labelList allPatch(joinProcessors(ownPatch));

    // Sort by patch and place: the decomposition must not show
    std::vector<label> order(allPatch.size());
    std::iota(order.begin(), order.end(), 0);

    std::sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            if (allPatch[a] != allPatch[b]) return allPatch[a] < allPatch[b];

            for (label i = 0; i < 9; ++i)
            {
                const scalar xa = allCorners[3*a + i/3][i%3];
                const scalar xb = allCorners[3*b + i/3][i%3];

                if (xa != xb) return xa < xb;
            }

            return a < b;
        }
    );

    corners.setSize(allCorners.size());
    patch_.resize(order.size());

    for (std::size_t i = 0; i < order.size(); ++i)
    {
        patch_[i] = allPatch[order[i]];

        for (label corner = 0; corner < 3; ++corner)
        {
            corners[3*label(i) + corner] = allCorners[3*order[i] + corner];
        }
    }
}


void Foam::boundarySurface::merge
(
    const pointField& corners,
    const scalar tolerance
)
{
    pointGrid grid(tolerance);
    labelList toMerged(corners.size());

    forAll(corners, i)
    {
        toMerged[i] = grid.nearest(corners[i]);

        if (toMerged[i] < 0)
        {
            toMerged[i] = grid.size();
            grid.append(corners[i]);
        }
    }

    pointField points(grid.size());
    forAll(points, i)
    {
        points[i] = grid[i];
    }

    std::vector<triangleTree::triangle> triangles(patch_.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
        for (label corner = 0; corner < 3; ++corner)
        {
            triangles[i][corner] = toMerged[3*label(i) + corner];
        }
    }

    tree_ = triangleTree(points, std::move(triangles));
}


// ************************************************************************* //
