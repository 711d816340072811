/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallBody.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::wallBody::makeParticles(const scalar dx)
{
    if (!search_.hasWalls())
    {
        return;
    }
    particles_.reset(new wallParticles(search_, dx));
    bounds_ = boundBox(search_.boundary().tree().points(), false);
    const vector layers(vector::uniform(2*wallParticles::nLayers*dx));
    bounds_.min() -= layers;
    bounds_.max() += layers;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallBody::wallBody(const wallSearch& search, const scalar dx)
:
    search_(search)
{
    makeParticles(dx);
}


Foam::wallBody::wallBody
(
    const polyMesh& mesh,
    const std::function<bool(const polyPatch&)>& isChosen,
    const scalar dx,
    autoPtr<solidBodyMotion> motion
)
:
    motion_(std::move(motion)),
    own_(new wallSearch(mesh, isChosen)),
    search_(*own_)
{
    makeParticles(dx);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::wallBody::setTime(const scalar t)
{
    if (!motion_)
    {
        return;
    }
    const solidBodyMotion::place place(motion_->at(t));
    const tensor back(place.axes.T());
    now_.toGround = {place.origin, place.axes, tensor::zero};
    now_.toBody = {-(back & place.origin), back, tensor::zero};
}


Foam::linearMap Foam::wallBody::velocity(const scalar t) const
{
    return
        motion_
      ? motion_->groundVelocity(t).after(now_.toBody)
      : linearMap();
}


Foam::linearMap Foam::wallBody::acceleration(const scalar t) const
{
    return
        motion_
      ? motion_->groundAcceleration(t).after(now_.toBody)
      : linearMap();
}


Foam::scalar Foam::wallBody::way(const placement& before) const
{
    scalar longest = 0;
    if (motion_)
    {
        const pointField corners(bounds_.points());
        for (const point& corner : corners)
        {
            longest = max
            (
                longest,
                mag(now_.toGround(corner) - before.toGround(corner))
            );
        }
    }
    return longest;
}


// ************************************************************************* //
