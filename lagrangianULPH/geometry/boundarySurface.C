/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boundarySurface.H"
#include "polyMesh.H"
#include <algorithm>
#include <map>
#include <numeric>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::boundarySurface::calcNormals()
{
    const pointField& points = tree_.points();
    const std::vector<triangleTree::triangle>& triangles = tree_.triangles();

    normal_.resize(triangles.size());
    edgeNormal_.resize(triangles.size());
    across_.resize(triangles.size(), {-1, -1, -1});
    pointNormal_.resize(points.size(), vector::zero);
    start_.resize(points.size() + 1, 0);

    std::map<std::pair<label, label>, std::vector<std::pair<label, int>>> edges;

    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
        const triangleTree::triangle& t = triangles[i];
        const vector area
        (
            (points[t[1]] - points[t[0]]) ^ (points[t[2]] - points[t[0]])
        );
        normal_[i] = area/(mag(area) + VSMALL);

        for (int j = 0; j < 3; ++j)
        {
            const label here = t[j], next = t[(j + 1) % 3];
            const vector u(points[next] - points[here]);
            const vector v(points[t[(j + 2) % 3]] - points[here]);

            pointNormal_[here] +=
                std::atan2(mag(u ^ v), u & v)*normal_[i];
            ++start_[here + 1];

            edges[std::minmax(here, next)].push_back({label(i), j});
        }
    }

    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    pointTriangles_.resize(3*triangles.size());

    std::vector<label> next(start_);
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
        for (const label pointi : triangles[i])
        {
            pointTriangles_[next[pointi]++] = label(i);
        }
    }

    for (const auto& edge : edges)
    {
        const std::vector<std::pair<label, int>>& sides = edge.second;

        vector sum(Zero);
        for (const auto& side : sides)
        {
            sum += normal_[side.first];
        }

        for (const auto& side : sides)
        {
            edgeNormal_[side.first][side.second] = sum;
        }

        if (sides.size() == 2)
        {
            across_[sides[0].first][sides[0].second] = sides[1].first;
            across_[sides[1].first][sides[1].second] = sides[0].first;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::boundarySurface::boundarySurface
(
    const polyMesh& mesh,
    const std::function<bool(const polyPatch&)>& isChosen
)
{
    pointField corners;
    gather(mesh, isChosen, corners);
    merge(corners, 1e-8*mesh.bounds().mag());
    calcNormals();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::vector& Foam::boundarySurface::pseudoNormal
(
    const triangleTree::hit& h
) const
{
    switch (h.on)
    {
        case triangleTree::part::edge:
            return edgeNormal_[h.triangle][h.which];

        case triangleTree::part::vertex:
            return pointNormal_[tree_.triangles()[h.triangle][h.which]];

        default:
            return normal_[h.triangle];
    }
}


std::vector<Foam::label> Foam::boundarySurface::around
(
    const triangleTree::hit& h
) const
{
    if (h.on == triangleTree::part::vertex)
    {
        const label pointi = tree_.triangles()[h.triangle][h.which];

        return std::vector<label>
        (
            pointTriangles_.begin() + start_[pointi],
            pointTriangles_.begin() + start_[pointi + 1]
        );
    }

    std::vector<label> triangles(1, h.triangle);

    if (h.on == triangleTree::part::edge && across_[h.triangle][h.which] >= 0)
    {
        triangles.push_back(across_[h.triangle][h.which]);
        std::sort(triangles.begin(), triangles.end());
    }

    return triangles;
}


Foam::scalar Foam::boundarySurface::signedDistance
(
    const point& p,
    const triangleTree::hit& h
) const
{
    const scalar distance = std::sqrt(h.distanceSqr);

    return ((p - h.position) & pseudoNormal(h)) > 0 ? -distance : distance;
}


// ************************************************************************* //
