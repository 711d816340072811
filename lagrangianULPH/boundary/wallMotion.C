/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallMotion.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::linearAcceleration Foam::wallMotion::seen
(
    const linearAcceleration& f,
    const scalar t
) const
{
    if (!motion_)
    {
        return f;
    }
    linearAcceleration turned(f);
    turned.constant = motion_->rotation(t).T() & f.constant;
    turned.perVelocity -= motion_->velocity(t).perLength;
    return turned;
}


Foam::linearAcceleration Foam::wallMotion::atRest
(
    const linearAcceleration& f,
    const scalar t
) const
{
    if (!motion_)
    {
        return f;
    }
    linearAcceleration total(motion_->inertia(t));
    total.constant += motion_->rotation(t).T() & f.constant;
    total.perLength += f.perLength;
    return total;
}


Foam::wallMotion::drift Foam::wallMotion::map
(
    const scalar t,
    const scalar dt
) const
{
    drift all;
    all.perVelocity *= dt;
    if (motion_)
    {
        const tankMotion::place before(motion_->at(t));
        const tankMotion::place after(motion_->at(t + dt));
        const tensor toTank(after.axes.T());
        all.turn = toTank & before.axes;
        all.shift = toTank & (before.origin - after.origin);
        all.perVelocity = dt*(toTank & motion_->rotation(t + 0.5*dt));
    }
    return all;
}


// ************************************************************************* //
