/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallMotion.H"

#include "inputChecks.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallMotion::wallMotion
(
    const dictionary& ulphProperties,
    const polyMesh& mesh
)
{
    const dictionary dict(ulphProperties.subOrEmptyDict("wallMotion"));
    if (!dict.found("bodies"))
    {
        if (dict.size())
        {
            motion_.reset(new solidBodyMotion(dict, mesh, true));
        }
    }
    else if (dict.found("solidBodyMotionFunction"))
    {
        FatalIOErrorInFunction(entryPlace(dict, "solidBodyMotionFunction"))
            << "Either the tank moves as a whole or bodies of its walls do." << nl
            << "    Leave out solidBodyMotionFunction, or bodies; see the tank from"
            << " itself by bodyForce { type tankMotion; ... } to have both."
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::linearMap Foam::wallMotion::seen
(
    const linearMap& f,
    const scalar t
) const
{
    if (!motion_)
    {
        return f;
    }
    linearMap turned(f);
    turned.constant = motion_->rotation(t).T() & f.constant;
    turned.perVelocity -= motion_->velocity(t).perLength;
    return turned;
}


Foam::linearMap Foam::wallMotion::atRest
(
    const linearMap& f,
    const scalar t
) const
{
    if (!motion_)
    {
        return f;
    }
    linearMap total(motion_->inertia(t));
    total.constant += motion_->rotation(t).T() & f.constant;
    total.perLength += f.perLength;
    return total;
}


Foam::linearMap Foam::wallMotion::drift
(
    const scalar t,
    const scalar dt,
    const scalar tVelocity
) const
{
    if (!motion_)
    {
        return {Zero, tensor::I, dt*tensor::I};
    }
    const tensor toTank(motion_->rotation(t + dt).T());
    return
    {
        -dt*(toTank & motion_->groundVelocity(tVelocity).constant),
        toTank & motion_->rotation(t),
        dt*(toTank & motion_->rotation(t + 0.5*dt))
    };
}


// ************************************************************************* //
