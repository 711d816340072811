/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSheets.H"
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::wallSheets::addSheet
(
    const std::vector<facet>& facets,
    const std::vector<label>& members,
    const vector& axis,
    const bool closed
)
{
    const pointField& points = surface_.tree().points();

    sheet s;
    s.axis = axis;
    s.closed = closed;

    scalar lowest = GREAT, highest = -GREAT;
    std::vector<point> begin, end;

    for (const label facei : members)
    {
        const facet& f = facets[facei];

        vector normal(f.normal - (f.normal & axis)*axis);
        normal /= mag(normal);
        const vector tangent(axis ^ normal);

        scalar first = GREAT, last = -GREAT;

        for (const label i : f.triangles)
        {
            sheetOf_[i] = size();

            for (const label pointi : surface_.tree().triangles()[i])
            {
                const point& p = points[pointi];
                first = Foam::min(first, p & tangent);
                last = Foam::max(last, p & tangent);
                lowest = Foam::min(lowest, p & axis);
                highest = Foam::max(highest, p & axis);
                s.bounds.add(p);
            }
        }

        const point plane((f.centre & normal)*normal);
        begin.push_back(plane + first*tangent);
        end.push_back(plane + last*tangent);
        s.normal.push_back(normal);
        s.tangent.push_back(tangent);
    }

    const std::size_t n = members.size();

    for (std::size_t i = 0; i <= n; ++i)
    {
        const bool open = !closed && (i == 0 || i == n);
        const std::size_t before = (i + n - 1) % n, after = i % n;

        if (open)
        {
            s.corner.push_back(i ? end.back() : begin.front());
            s.miter.push_back(i ? s.normal.back() : s.normal.front());
        }
        else
        {
            const vector& a = s.normal[before];
            const vector& b = s.normal[after];
            s.corner.push_back(0.5*(end[before] + begin[after]));
            s.miter.push_back((a + b)/(1 + (a & b)));
        }
    }

    setLayers(s);
    setLevels(s, lowest, highest);
    sheets_.push_back(s);
}


void Foam::wallSheets::setLayers(sheet& s) const
{
    for (label layer = 0; layer < nLayers_; ++layer)
    {
        const scalar offset = (layer + 0.5)*dx_;
        std::vector<scalar> along(1, 0);

        for (std::size_t i = 0; i < s.tangent.size(); ++i)
        {
            const vector side
            (
                s.corner[i + 1] - s.corner[i]
              + offset*(s.miter[i + 1] - s.miter[i])
            );

            // A tight concave bend leaves no room for the outer layers
            along.push_back
            (
                along.back() + Foam::max(side & s.tangent[i], scalar(0))
            );
        }

        const scalar length = along.back();

        s.nAlong.push_back
        (
            length < 0.5*dx_
          ? 0
          : Foam::max(label(std::lround(length/dx_)), label(1))
        );
        s.along.push_back(along);
    }
}


void Foam::wallSheets::setLevels
(
    sheet& s,
    const scalar first,
    const scalar last
)
{
    if (emptyDir_ != vector::zero)
    {
        s.level.push_back(midPlane_ & s.axis);
        s.levelStep.push_back(1);
        s.levelExtended.push_back(false);
        return;
    }

    const label n =
        Foam::max(label(std::lround((last - first)/dx_)), label(1));
    const scalar step = (last - first)/n;

    for (label i = -nLayers_; i < n + nLayers_; ++i)
    {
        const bool extended = i < 0 || i >= n;

        s.level.push_back
        (
            i < 0 ? first + (i + 0.5)*dx_
          : i < n ? first + (i + 0.5)*step
          : last + (i - n + 0.5)*dx_
        );
        s.levelStep.push_back(extended ? dx_ : step);
        s.levelExtended.push_back(extended);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallSheets::wallSheets
(
    const wallSearch& search,
    const scalar dx,
    const label nLayers
)
:
    surface_(search.boundary()),
    dx_(dx),
    nLayers_(nLayers),
    emptyDir_(vector::zero),
    midPlane_(search.bounds().midpoint())
{
    for (direction d = 0; d < 3; ++d)
    {
        if (search.mesh().geometricD()[d] < 0) emptyDir_[d] = 1;
    }

    std::vector<facet> facets = joinPlanes(search.mesh());
    const std::vector<label> facetOf(sheetOf_);
    joinSmoothly(facets, facetOf);

    for (label& sheeti : sheetOf_)
    {
        if (sheeti != notWall) sheeti = noSheet;
    }

    for (std::size_t i = 0; i < facets.size(); ++i)
    {
        const facet& f = facets[i];

        if (f.rough || sheetOf_[f.triangles[0]] != noSheet) continue;

        vector axis(emptyDir_);

        if (axis == vector::zero)
        {
            axis =
                f.joined.size()
              ? f.hinge
              : vector(f.normal ^ longestEdge(f, facetOf));
        }

        bool closed;
        const std::vector<label> members =
            profile(facets, label(i), axis, closed);

        addSheet(facets, members, axis, closed);
    }
}


// ************************************************************************* //
