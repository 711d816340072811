/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPlaces.H"
#include "joinProcessors.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::meshPlaces::askOthers
(
    const polyMesh& mesh,
    const cellLocator& locator,
    const UList<point>& points,
    labelList& rank,
    labelList& cell
)
{
    boundBox own(mesh.points(), false);
    own.inflate(1e-6);
    const List<boundBox> boxes(joinProcessors(List<boundBox>(1, own)));

    labelList sent(UPstream::nProcs(), 0);
    std::vector<label> asked;
    std::vector<scalar> places;
    forAll(boxes, other)
    {
        forAll(points, i)
        {
            if
            (
                other != UPstream::myProcNo() && cell[i] < 0
             && boxes[other].contains(points[i])
            )
            {
                ++sent[other];
                asked.push_back(i);
                for (const scalar x : {points[i].x(), points[i].y(), points[i].z()})
                {
                    places.push_back(x);
                }
            }
        }
    }

    const rankExchange questions(sent);
    const std::vector<scalar> toFind(questions.forth(places, 3));
    std::vector<scalar> found;
    for (std::size_t i = 0; i < toFind.size(); i += 3)
    {
        found.push_back
        (
            locator.find(point(toFind[i], toFind[i + 1], toFind[i + 2]))
        );
    }
    const std::vector<scalar> answers(questions.back(found, 1));

    std::size_t next = 0;
    forAll(sent, other)
    {
        for (label n = 0; n < sent[other]; ++n, ++next)
        {
            const label i = asked[next];
            if (answers[next] >= 0 && cell[i] < 0)
            {
                rank[i] = other;
                cell[i] = label(answers[next]);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::meshPlaces::meshPlaces
(
    const polyMesh& mesh,
    const cellLocator& locator,
    const UList<point>& points
)
{
    labelList cell(locator.find(points));
    labelList rank(points.size(), UPstream::myProcNo());
    if (UPstream::parRun())
    {
        askOthers(mesh, locator, points, rank, cell);
    }

    std::vector<std::vector<label>> to(UPstream::nProcs());
    forAll(points, i)
    {
        if (cell[i] < 0)
        {
            nowhere_.append(i);
        }
        else
        {
            to[rank[i]].push_back(i);
        }
    }
    labelList sent(UPstream::nProcs());
    forAll(sent, other)
    {
        sent[other] = label(to[other].size());
        held_.insert(held_.end(), to[other].begin(), to[other].end());
    }
    ways_ = rankExchange(sent);
    cells_.resize(sum(ways_.received()));
    cells_ = distributed(cell);
}


// ************************************************************************* //
