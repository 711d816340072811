/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "guard.H"

#include "inputChecks.H"
#include "joinProcessors.H"
#include "StringStream.H"
#include "Time.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static scalar bound
(
    const dictionary& ulphProperties,
    const word& name,
    const scalar deflt,
    const scalarMinMax& range
)
{
    const dictionary dict(ulphProperties.subOrEmptyDict("guard"));
    refuseMisspelt
    (
        dict, {"maxMach", "maxDensityError", "minDeltaTFraction", "maxEscaped"}
    );
    return getInRange(dict, name, deflt, range);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::guard::stop
(
    const std::string& what,
    const label i,
    const bool inState
) const
{
    OStringStream where;
    if (i >= 0)
    {
        where
            << "    particle " << cloud_.origId()[i] << " at "
            << cloud_.position(i) << ", U "
            << cloud_.toVector(cloud_.v(), i) << ", rho "
            << cloud_.rho0() + cloud_.densityExcess()(i) << nl;
    }
    const stringList places(joinProcessors(stringList(i >= 0 ? 1 : 0, where.str())));
    const Time& time = cloud_.mesh().time();
    const word when(time.timeName());
    const bool kept = write_();

    FatalErrorInFunction
        << "The run has become unstable: " << what.c_str() << nl
        << (places.empty() ? "" : places[0].c_str())
        << "    time " << when << "; the "
        << (kept || !inState ? "last good state" : "state that holds it")
        << " is written as time " << time.timeName() << '.' << nl
        << "    Look at it in ParaView; a smaller maxCo, mode default, or a "
        << "larger c0 (10 times the" << nl
        << "    highest speed) are the usual mends; guard { } in "
        << "constant/ulphProperties sets the limits."
        << exit(FatalError);

    ::abort();
}


Foam::label Foam::guard::firstAbove
(
    const particleField& field,
    const scalar bound
) const
{
    for (label i = 0; i < cloud_.size(); ++i)
    {
        scalar length2 = 0;
        for (int c = 0; c < field.nComponents(); ++c)
        {
            length2 += sqr(field(i, c));
        }
        if (!(length2 <= sqr(bound)))
        {
            return i;
        }
    }
    return -1;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::guard::guard
(
    const dictionary& ulphProperties,
    const ulphCloud& cloud,
    const std::function<bool()>& write
)
:
    cloud_(cloud),
    maxMach_
    (
        bound(ulphProperties, "maxMach", 1, scalarMinMax::ge(0))
    ),
    maxDensityError_
    (
        bound(ulphProperties, "maxDensityError", 0.3, scalarMinMax(0, 0.9))
    ),
    minDeltaTFraction_
    (
        bound(ulphProperties, "minDeltaTFraction", 1e-3, scalarMinMax(0, 1))
    ),
    maxEscaped_
    (
        label(bound(ulphProperties, "maxEscaped", 0, scalarMinMax(0, labelMax)))
    ),
    write_(write)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::guard::checkRates(const bool ok, const wordList& rates) const
{
    if (returnReduce(ok, andOp<bool>()))
    {
        return;
    }
    for (const word& name : rates)
    {
        const particleField* const rate = cloud_.derived(name);
        const label i = rate ? firstAbove(*rate, ROOTVGREAT) : -1;
        if (returnReduce(i >= 0, orOp<bool>()))
        {
            stop(name + " is not finite", i);
        }
    }
    stop("a rate of change is not finite", -1);
}


bool Foam::guard::strained
(
    const scalar maxSpeed,
    const scalar maxExcess,
    const scalar dt
) const
{
    constexpr scalar part = 0.25;
    return
        dt*cloud_.c0() > cloud_.h()
     || maxSpeed > part*maxMach_*cloud_.c0()
     || maxExcess > part*maxDensityError_*cloud_.rho0();
}


void Foam::guard::checkState
(
    const scalar maxSpeed,
    const scalar maxExcess
) const
{
    if (!(maxSpeed <= maxMach_*cloud_.c0()))
    {
        stop
        (
            "speed above " + std::to_string(maxMach_) + " c0",
            firstAbove(cloud_.v(), maxMach_*cloud_.c0()),
            true
        );
    }
    if (!(maxExcess <= maxDensityError_*cloud_.rho0()))
    {
        stop
        (
            "density off by more than " + std::to_string(maxDensityError_)
          + " rho0",
            firstAbove
            (
                cloud_.densityExcess(), maxDensityError_*cloud_.rho0()
            ),
            true
        );
    }
}


void Foam::guard::countEscaped(const labelUList& escaped)
{
    nEscaped_ += returnReduce(escaped.size(), sumOp<label>());
    if (nEscaped_ > maxEscaped_)
    {
        stop
        (
            std::to_string(nEscaped_) + " particles have left the mesh",
            escaped.empty() ? -1 : escaped[0]
        );
    }
}


void Foam::guard::report(Ostream& os) const
{
    os  << "    guard: " << nEscaped_ << " particles left the mesh" << nl;
}


void Foam::guard::checkDeltaT
(
    const scalar deltaT,
    const scalar acoustic
) const
{
    if (!(deltaT >= minDeltaTFraction_*acoustic))
    {
        stop
        (
            "the time step collapsed to " + std::to_string(deltaT/acoustic)
          + " of h/c0",
            -1
        );
    }
}


// ************************************************************************* //
