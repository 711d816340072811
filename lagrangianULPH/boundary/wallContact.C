/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallContact.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::wallContact::height(const plane& wall) const
{
    scalar s = -wall.offset;
    for (int k = 0; k < cloud_.D(); ++k)
    {
        s += cloud_.x().component(k)[wall.particle]*wall.normal[k];
    }
    return s;
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
        const wallSearch::wallPoint nearest(search_.nearest(place, nearer));
        if (!nearest.found())
        {
            return;
        }
        plane wall;
        wall.particle = particle;
        wall.offset = 0;
        for (int k = 0; k < cloud_.D(); ++k)
        {
            const direction d = cloud_.axis(k);
            wall.normal[k] = nearest.normal[d];
            wall.offset += nearest.position[d]*nearest.normal[d];
        }
        found.push_back(wall);
        place += (reach - nearest.distance)*nearest.normal;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallContact::wallContact(ulphCloud& cloud, const wallSearch& search)
:
    cloud_(cloud),
    search_(search),
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

    const int D = cloud_.D();
    const scalar reach = cloud_.dx() + neighbours.skin();
    const ulph::clusterList& list = neighbours.fluidList();
    std::vector<std::vector<plane>> found(list.size());

    #pragma omp parallel for schedule(dynamic, 16)
    for (int i = 0; i < list.size(); ++i)
    {
        const ulph::clusterList::cluster& c = list[i];
        for (int l = 0; l < c.count && c.fluidEnd != c.end; ++l)
        {
            findPlanes(c.first + l, reach, found[i]);
        }
    }

    planes_.clear();
    for (const std::vector<plane>& walls : found)
    {
        for (const plane& wall : walls)
        {
            planes_.push_back(wall);
            const scalar s = height(wall);
            if (s < 0)
            {
                for (int k = 0; k < D; ++k)
                {
                    cloud_.x().component(k)[wall.particle] -=
                        (s - 0.1*distance_)*wall.normal[k];
                }
                ++nReturned_;
            }
        }
    }
}


void Foam::wallContact::limitVelocity(const linearMap& walls)
{
    const int D = cloud_.D();
    for (const plane& wall : planes_)
    {
        if (height(wall) >= distance_)
        {
            continue;
        }
        const vector wallV(walls(cloud_.position(wall.particle)));
        scalar approach = 0;
        for (int k = 0; k < D; ++k)
        {
            approach +=
                (
                    wallV[cloud_.axis(k)]
                  - cloud_.v().component(k)[wall.particle]
                )*wall.normal[k];
        }
        if (approach > 0)
        {
            for (int k = 0; k < D; ++k)
            {
                cloud_.v().component(k)[wall.particle] +=
                    approach*wall.normal[k];
            }
            impulse_ += approach*cloud_.mass()(wall.particle);
            ++nContacts_;
        }
    }
}


void Foam::wallContact::limitPosition()
{
    // A shift shorter than 0.2 dx cannot pass the wall from contact distance,
    // but many would
    const scalar least = 0.1*distance_;
    for (const plane& wall : planes_)
    {
        const scalar s = height(wall);
        if (s < least)
        {
            for (int k = 0; k < cloud_.D(); ++k)
            {
                cloud_.x().component(k)[wall.particle] +=
                    (least - s)*wall.normal[k];
            }
            ++nReturned_;
        }
    }
}


void Foam::wallContact::report(Ostream& os) const
{
    os  << "    walls: " << nContacts_ << " contacts, impulse " << impulse_
        << ", " << nReturned_ << " positions put back on the wall" << nl;
}


// ************************************************************************* //
