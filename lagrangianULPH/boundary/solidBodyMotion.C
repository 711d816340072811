/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidBodyMotion.H"
#include "cyclicPolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Interval of the differences [s]
static constexpr scalar interval = 1e-3;

//- Controls of a time that only gives its value
static dictionary clockControls()
{
    dictionary controls;
    controls.add("startFrom", word("startTime"));
    controls.add("startTime", 0);
    controls.add("stopAt", word("endTime"));
    controls.add("endTime", 0);
    controls.add("deltaT", interval);
    controls.add("writeControl", word("timeStep"));
    controls.add("writeInterval", 1);
    controls.add("runTimeModifiable", word("no"));
    return controls;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::FixedList<Foam::solidBodyMotion::place, 5> Foam::solidBodyMotion::around
(
    const scalar t
) const
{
    FixedList<place, 5> all;
    forAll(all, i)
    {
        all[i] = at(t + (i - 2)*interval);
    }
    return all;
}


template<class Type>
Type Foam::solidBodyMotion::rate(const FixedList<place, 5>& all, Type place::*x)
{
    return
        (8*(all[3].*x - all[1].*x) - (all[4].*x - all[0].*x))/(12*interval);
}


template<class Type>
Type Foam::solidBodyMotion::secondRate(const FixedList<place, 5>& all, Type place::*x)
{
    return
        (
            16*(all[1].*x + all[3].*x) - (all[0].*x + all[4].*x) - 30*(all[2].*x)
        )/(12*sqr(interval));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidBodyMotion::solidBodyMotion
(
    const dictionary& dict,
    const polyMesh& mesh,
    const bool wholeTank
)
:
    mesh_(mesh),
    dict_(dict),
    cyclicTank_
    (
        wholeTank
     && mesh.boundaryMesh().findPatchIDs<cyclicPolyPatch>().size()
    ),
    t0_(dict.getOrDefault<scalar>("t0", 0)),
    clock_
    (
        clockControls(),
        mesh.time().rootPath(),
        mesh.time().caseName(),
        mesh.time().system(),
        mesh.time().constant(),
        false,
        false
    ),
    function_(solidBodyMotionFunction::New(dict_, clock_))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::solidBodyMotion::place Foam::solidBodyMotion::at(const scalar t) const
{
    septernion motion;
    #pragma omp critical(solidBodyMotion)
    {
        clock_.setTime(t - t0_, 0);
        motion = function_->transformation();
    }

    place now;
    now.origin = motion.transformPoint(Zero);
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        vector axis(Zero);
        axis[d] = 1;
        const vector turned(motion.transformPoint(axis) - now.origin);
        if (mesh_.solutionD()[d] < 0 && mag(turned - axis) > ROOTSMALL)
        {
            FatalIOErrorInFunction(dict_)
                << "solidBodyMotionFunction " << function_->type()
                << " turns the walls out of the plane of the flow at time " << t
                << " s." << nl
                << "    Choose an axis across the empty patches, or a "
                << "motion that does not turn, for instance "
                << "oscillatingLinearMotion."
                << exit(FatalIOError);
        }
        if (cyclicTank_ && mag(turned - axis) > ROOTSMALL)
        {
            FatalIOErrorInFunction(dict_)
                << "solidBodyMotionFunction " << function_->type()
                << " turns, at time " << t << " s, a tank whose flow repeats itself: "
                << "what is pushed outwards at one cyclic patch would be pushed "
                << "inwards at the other." << nl
                << "    Choose a motion that does not turn, for instance "
                << "oscillatingLinearMotion, or make the cyclic patches walls."
                << exit(FatalIOError);
        }
        for (direction k = 0; k < vector::nComponents; ++k)
        {
            now.axes(k, d) = turned[k];
        }
    }
    return now;
}


Foam::linearMap Foam::solidBodyMotion::groundVelocity(const scalar t) const
{
    const FixedList<place, 5> all(around(t));
    return {rate(all, &place::origin), rate(all, &place::axes), tensor::zero};
}


Foam::linearMap Foam::solidBodyMotion::groundAcceleration(const scalar t) const
{
    const FixedList<place, 5> all(around(t));
    return
    {
        secondRate(all, &place::origin),
        secondRate(all, &place::axes),
        tensor::zero
    };
}


Foam::linearMap Foam::solidBodyMotion::velocity(const scalar t) const
{
    const tensor toBody(rotation(t).T());
    const linearMap v(groundVelocity(t));
    return {toBody & v.constant, toBody & v.perLength, tensor::zero};
}


Foam::linearMap Foam::solidBodyMotion::inertia(const scalar t) const
{
    const tensor toBody(rotation(t).T());
    const linearMap a(groundAcceleration(t));
    return
    {
        -(toBody & a.constant),
        -(toBody & a.perLength),
        -2*(toBody & groundVelocity(t).perLength)
    };
}


Foam::linearMap Foam::solidBodyMotion::meanInertia
(
    const scalar first,
    const scalar last
) const
{
    linearMap mean(inertia(0.5*(first + last)));
    if (first < last)
    {
        const tensor perTime(rotation(0.5*(first + last)).T()/(last - first));
        const linearMap before(groundVelocity(first));
        const linearMap after(groundVelocity(last));
        mean.constant = perTime & (before.constant - after.constant);
        mean.perLength = perTime & (before.perLength - after.perLength);
    }
    return mean;
}


// ************************************************************************* //
