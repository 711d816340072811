/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Joining of boundary triangles to the planes and profiles of wallSheets.

\*---------------------------------------------------------------------------*/

#include "wallSheets.H"
#include "wallPolyPatch.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Normals this near to each other belong to one plane (0.26 degrees)
constexpr scalar samePlane = 1 - 1e-5;

//- Distance from the plane allowed in it, over the particle spacing
constexpr scalar flatness = 0.02;

//- A bend by less than 30 degrees is smooth
const scalar smoothBend = std::sqrt(scalar(3))/2;

//- Sine of the angle between directions held to be parallel
constexpr scalar parallel = 0.01;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<Foam::wallSheets::facet> Foam::wallSheets::joinPlanes
(
    const polyMesh& mesh
)
{
    const pointField& points = surface_.tree().points();
    const auto& triangles = surface_.tree().triangles();

    std::vector<facet> facets;
    std::vector<label>& facetOf = sheetOf_;
    facetOf.assign(surface_.size(), notWall);

    const auto isFree = [&](const label i)
    {
        return
            i >= 0 && facetOf[i] == notWall
         && isA<wallPolyPatch>(mesh.boundaryMesh()[surface_.patch(i)]);
    };

    for (label seed = 0; seed < surface_.size(); ++seed)
    {
        if (!isFree(seed)) continue;

        facet f;
        f.hinge = vector::zero;
        f.rough = false;
        f.triangles.push_back(seed);
        facetOf[seed] = label(facets.size());

        // The plane is the mean of what has been joined so far
        vector area(vector::zero), moment(vector::zero);
        scalar magArea = 0;

        for (std::size_t next = 0; next < f.triangles.size(); ++next)
        {
            const label i = f.triangles[next];
            const auto& t = triangles[i];
            const scalar a =
                0.5
               *mag
                (
                    (points[t[1]] - points[t[0]])
                  ^ (points[t[2]] - points[t[0]])
                );

            area += a*surface_.normal(i);
            moment += a/3*(points[t[0]] + points[t[1]] + points[t[2]]);
            magArea += a;
            f.normal = area/mag(area);
            f.centre = moment/magArea;

            for (int edgei = 0; edgei < 3; ++edgei)
            {
                const label j = surface_.across(i, edgei);

                if (!isFree(j) || (surface_.normal(j) & f.normal) < samePlane)
                {
                    continue;
                }

                bool flat = true;
                for (const label pointi : triangles[j])
                {
                    flat =
                        flat
                     && std::abs((points[pointi] - f.centre) & f.normal)
                      < flatness*dx_;
                }

                if (flat)
                {
                    facetOf[j] = facetOf[seed];
                    f.triangles.push_back(j);
                }
            }
        }

        facets.push_back(f);
    }

    return facets;
}


void Foam::wallSheets::joinSmoothly
(
    std::vector<facet>& facets,
    const std::vector<label>& facetOf
) const
{
    const pointField& points = surface_.tree().points();

    for (facet& f : facets)
    {
        for (const label i : f.triangles)
        {
            const auto& t = surface_.tree().triangles()[i];

            for (int edgei = 0; edgei < 3; ++edgei)
            {
                const label j = surface_.across(i, edgei);
                const label other = j < 0 ? notWall : facetOf[j];

                if
                (
                    other < 0
                 || other == facetOf[i]
                 || (facets[other].normal & f.normal) < smoothBend
                )
                {
                    continue;
                }

                const point& a = points[t[edgei]];
                const point& b = points[t[(edgei + 1) % 3]];
                const vector along((b - a)/mag(b - a));

                if (f.hinge == vector::zero)
                {
                    f.hinge = along;
                }
                else if (mag(f.hinge ^ along) > parallel)
                {
                    f.rough = true;
                }

                bool known = false;
                for (const auto& joined : f.joined)
                {
                    known = known || joined.first == other;
                }

                if (!known)
                {
                    f.joined.push_back({other, 0.5*(a + b)});
                }
            }
        }

        f.rough = f.rough || f.joined.size() > 2;
    }
}


Foam::vector Foam::wallSheets::longestEdge
(
    const facet& f,
    const std::vector<label>& facetOf
) const
{
    const pointField& points = surface_.tree().points();

    // Sums of the edge lengths by direction
    std::vector<std::pair<vector, scalar>> sums;

    for (const label i : f.triangles)
    {
        const auto& t = surface_.tree().triangles()[i];

        for (int edgei = 0; edgei < 3; ++edgei)
        {
            const label j = surface_.across(i, edgei);

            if (j >= 0 && facetOf[j] == facetOf[i]) continue;

            vector edge(points[t[(edgei + 1) % 3]] - points[t[edgei]]);
            const scalar length = mag(edge);
            edge /= length;

            bool known = false;
            for (auto& sum : sums)
            {
                if (mag(sum.first/mag(sum.first) ^ edge) < parallel)
                {
                    // Opposite edges of one direction run against each other
                    sum.first += (sum.first & edge) < 0 ? -length*edge
                                                         : length*edge;
                    sum.second += length;
                    known = true;
                    break;
                }
            }

            if (!known)
            {
                sums.push_back({length*edge, length});
            }
        }
    }

    std::pair<vector, scalar> best(vector::zero, 0);
    for (const auto& sum : sums)
    {
        if (sum.second > (1 + 1e-4)*best.second) best = sum;
    }

    vector along(best.first - (best.first & f.normal)*f.normal);

    return along/mag(along);
}


std::vector<Foam::label> Foam::wallSheets::profile
(
    const std::vector<facet>& facets,
    const label start,
    const vector& axis,
    bool& closed
) const
{
    // Facets sharing the axis; +1: next along the tangent, -1: before
    const auto next = [&](const label facei, const scalar sense)
    {
        const facet& f = facets[facei];
        const vector tangent(axis ^ f.normal);

        for (const auto& joined : f.joined)
        {
            const facet& g = facets[joined.first];

            if
            (
                !g.rough
             && mag(g.hinge ^ axis) < parallel
             && sense*((joined.second - f.centre) & tangent) > 0
            )
            {
                return joined.first;
            }
        }

        return label(-1);
    };

    closed = false;

    // Back to the beginning, then forwards
    label first = start;
    for (label at = next(start, -1); at >= 0; at = next(at, -1))
    {
        if (at == start)
        {
            closed = true;
            first = start;
            break;
        }
        first = at;
    }

    std::vector<label> members(1, first);
    for (label at = next(first, 1); at >= 0 && at != first; at = next(at, 1))
    {
        members.push_back(at);
    }

    return members;
}


// ************************************************************************* //
