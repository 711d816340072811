/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tankMotion.H"

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

Foam::FixedList<Foam::vector, 5> Foam::tankMotion::displacements
(
    const scalar t
) const
{
    FixedList<vector, 5> all;
    forAll(all, i)
    {
        all[i] = displacement(t + (i - 2)*interval);
    }
    return all;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tankMotion::tankMotion(const dictionary& dict, const Time& time)
:
    dict_(dict),
    t0_(dict.getOrDefault<scalar>("t0", 0)),
    clock_
    (
        clockControls(),
        time.rootPath(),
        time.caseName(),
        time.system(),
        time.constant(),
        false,
        false
    ),
    function_(solidBodyMotionFunction::New(dict_, clock_))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::tankMotion::displacement(const scalar t) const
{
    septernion motion;
    #pragma omp critical(tankMotion)
    {
        clock_.setTime(t - t0_, 0);
        motion = function_->transformation();
    }

    if (mag(motion.r().v()) > SMALL)
    {
        FatalIOErrorInFunction(dict_)
            << "solidBodyMotionFunction " << function_->type()
            << " turns the tank at time " << t << " s: only translations "
            << "are provided." << nl
            << "    Choose one, for instance oscillatingLinearMotion or "
            << "linearMotion."
            << exit(FatalIOError);
    }
    return motion.transformPoint(Zero);
}


Foam::vector Foam::tankMotion::velocity(const scalar t) const
{
    const FixedList<vector, 5> d(displacements(t));
    return (8*(d[3] - d[1]) - (d[4] - d[0]))/(12*interval);
}


Foam::vector Foam::tankMotion::acceleration(const scalar t) const
{
    const FixedList<vector, 5> d(displacements(t));
    return
        (16*(d[1] + d[3]) - (d[0] + d[4]) - 30*d[2])/(12*sqr(interval));
}


// ************************************************************************* //
