/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallContact.H"
#include "clusterShares.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::wallContact::height(const plane& wall) const
{
    const wallBody& body = bodies_[wall.body];
    if (body.moves())
    {
        const point place(body.now().toBody(cloud_.position(wall.particle)));
        return (place & wall.normal) - wall.offset;
    }
    scalar s = -wall.offset;
    for (int k = 0; k < cloud_.D(); ++k)
    {
        s += cloud_.x().component(k)[wall.particle]*wall.normal[cloud_.axis(k)];
    }
    return s;
}


void Foam::wallContact::lift(const plane& wall, const scalar distance)
{
    const vector normal(bodies_[wall.body].now().toGround.perLength & wall.normal);
    for (int k = 0; k < cloud_.D(); ++k)
    {
        cloud_.x().component(k)[wall.particle] +=
            distance*normal[cloud_.axis(k)];
    }
}


void Foam::wallContact::findPlanes
(
    const ulph::clusterList::cluster& c,
    const scalar reach,
    std::vector<plane>& found
) const
{
    const label last = c.first + c.count;
    point centre(Zero);
    for (label p = c.first; p < last; ++p)
    {
        centre += cloud_.position(p)/c.count;
    }
    scalar radius = 0;
    for (label p = c.first; p < last; ++p)
    {
        radius = max(radius, mag(cloud_.position(p) - centre));
    }

    // No member is nearer to a wall than the centre by more than it is off that
    const wallSearch::wallPoint on(bodies_.nearest(centre, reach + radius).on);
    for (label p = c.first; p < last && on.found(); ++p)
    {
        if (mag(on.distance) - mag(cloud_.position(p) - centre) < reach)
        {
            findPlanes(p, reach, found);
        }
    }
}


void Foam::wallContact::findPlanes
(
    const label particle,
    const scalar reach,
    std::vector<plane>& found
) const
{
    // What a wall already found shows at the distance reach is no other wall
    const scalar nearer = 0.999*reach;

    point place(cloud_.position(particle));
    for (int n = 0; n < cloud_.D(); ++n)
    {
        const wallBodies::nearestWall nearest(bodies_.nearest(place, nearer));
        const wallSearch::wallPoint& on = nearest.on;
        if (!on.found())
        {
            return;
        }
        found.push_back
        (
            {particle, nearest.body, on.normal, on.position & on.normal}
        );
        place +=
            (reach - on.distance)
           *(bodies_[nearest.body].now().toGround.perLength & on.normal);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallContact::wallContact(ulphCloud& cloud, wallBodies& bodies)
:
    cloud_(cloud),
    bodies_(bodies),
    distance_(0.25*cloud.dx())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::wallContact::update
(
    const neighbourSearch& neighbours
)
{
    if (!hasWalls())
    {
        return;
    }

    const scalar reach = cloud_.dx() + neighbours.widestSkin();
    const ulph::clusterList& list = neighbours.fluidList();
    const std::vector<int>& which = neighbours.newLists();
    if (label(which.size()) == list.size())
    {
        planes_.clear();
    }
    if (which.empty())
    {
        return;
    }

    std::vector<std::vector<plane>> found(which.size());
    anew_.assign(cloud_.size(), 0);

    ulph::clusterShares shares(int(which.size()));

    #pragma omp parallel
    for (const int i : shares)
    {
        const ulph::clusterList::cluster& c = list[which[i]];
        std::fill_n(anew_.begin() + c.first, c.count, 1);
        if (c.besideWall())
        {
            findPlanes(c, reach, found[i]);
        }
    }

    const auto isOld = [&](const plane& wall) { return anew_[wall.particle]; };
    planes_.erase
    (
        std::remove_if(planes_.begin(), planes_.end(), isOld), planes_.end()
    );
    for (const std::vector<plane>& walls : found)
    {
        for (const plane& wall : walls)
        {
            planes_.push_back(wall);
            const scalar s = height(wall);
            if (s < 0)
            {
                lift(wall, 0.1*distance_ - s);
                ++nReturned_;
            }
        }
    }
}


void Foam::wallContact::limitVelocity
(
    const scalar t,
    const scalar dt,
    const linearMap& tank
)
{
    bodies_.setTime(t);
    std::vector<linearMap> own(bodies_.size());
    forAll(bodies_, b)
    {
        own[b] = bodies_[b].velocity(t + 0.5*dt);
    }
    const int D = cloud_.D();
    for (const plane& wall : planes_)
    {
        if (height(wall) >= distance_)
        {
            continue;
        }
        const label i = wall.particle;
        const point place(cloud_.position(i));
        const vector normal
        (
            bodies_[wall.body].now().toGround.perLength & wall.normal
        );
        const vector wallV(tank(place) + own[wall.body](place));
        const scalar approach =
            (wallV - cloud_.toVector(cloud_.v(), i)) & normal;
        if (approach > 0)
        {
            for (int k = 0; k < D; ++k)
            {
                cloud_.v().component(k)[i] += approach*normal[cloud_.axis(k)];
            }
            impulse_ += approach*cloud_.mass()(i);
            ++nContacts_;
        }
    }
}


void Foam::wallContact::limitPosition(const scalar t)
{
    // A shift shorter than 0.2 dx cannot pass the wall from contact distance,
    // but many would
    const scalar least = 0.1*distance_;

    bodies_.setTime(t);
    for (const plane& wall : planes_)
    {
        const scalar s = height(wall);
        if (s < least)
        {
            lift(wall, least - s);
            ++nReturned_;
        }
    }
}


void Foam::wallContact::report(Ostream& os) const
{
    os  << "    walls: " << returnReduce(nContacts_, sumOp<label>())
        << " contacts, impulse " << returnReduce(impulse_, sumOp<scalar>())
        << ", " << returnReduce(nReturned_, sumOp<label>())
        << " positions put back on the wall" << nl;
}


// ************************************************************************* //
