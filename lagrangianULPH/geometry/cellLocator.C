/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellLocator.H"
#include "polyMeshTetDecomposition.H"
#include "tetIndices.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::cellLocator::walk(const point& p, label celli) const
{
    const vectorField& centres = mesh_.faceCentres();
    const vectorField& areas = mesh_.faceAreas();
    const labelList& owner = mesh_.faceOwner();

    for (label step = 0; step < maxSteps_; ++step)
    {
        label through = -1;
        scalar farthest = 0;

        for (const label facei : mesh_.cells()[celli])
        {
            scalar outside =
                ((p - centres[facei]) & areas[facei])/mag(areas[facei]);

            if (owner[facei] != celli) outside = -outside;

            if (outside > farthest)
            {
                farthest = outside;
                through = facei;
            }
        }

        if (through < 0)
        {
            return celli;
        }

        if (!mesh_.isInternalFace(through))
        {
            return -1;
        }

        celli =
            owner[through] == celli
          ? mesh_.faceNeighbour()[through]
          : owner[through];
    }

    return -1;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellLocator::cellLocator(const polyMesh& mesh)
:
    mesh_(mesh)
{
    // Demand-driven and collective: made while all processors are here
    mesh_.cellTree();
    mesh_.tetBasePtIs();
    mesh_.faceCentres();
    mesh_.cells();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::cellLocator::find(const point& p, const label seed) const
{
    if (seed >= 0)
    {
        const label celli = walk(p, seed);

        if (celli >= 0) return celli;
    }

    return mesh_.nCells() ? mesh_.findCell(p, polyMesh::CELL_TETS) : -1;
}


Foam::labelList Foam::cellLocator::find(const UList<point>& points) const
{
    labelList cells(points.size(), -1);
    label seed = -1;

    forAll(points, i)
    {
        cells[i] = find(points[i], seed);

        if (cells[i] >= 0) seed = cells[i];
    }

    return cells;
}


Foam::cellLocator::tetPlace Foam::cellLocator::place
(
    const point& p,
    const label celli
) const
{
    // The tetrahedron in which the smallest coordinate is largest holds the
    // point, or comes nearest to holding it where round-off leaves a gap
    tetPlace best{-1, -1, barycentric()};
    scalar largest = -GREAT;

    for
    (
        const tetIndices& tet
      : polyMeshTetDecomposition::cellTetIndices(mesh_, celli)
    )
    {
        barycentric coordinates;
        tet.tet(mesh_).pointToBarycentric(p, coordinates);

        const scalar smallest = cmptMin(coordinates);

        if (smallest > largest)
        {
            largest = smallest;
            best = {tet.face(), tet.tetPt(), coordinates};
        }
    }

    return best;
}


Foam::point Foam::cellLocator::position
(
    const label celli,
    const tetPlace& place
) const
{
    return tetIndices(celli, place.tetFace, place.tetPt).tet(mesh_)
        .barycentricToPoint(place.coordinates);
}


// ************************************************************************* //
