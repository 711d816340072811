/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ledger.H"

#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <ctime>
#include <iomanip>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static scalar seconds(const clockid_t id)
{
    timespec t;
    clock_gettime(id, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::ledger::section::section(ledger& where, const word& name)
:
    ledger_(where),
    name_(name),
    cpu_(cpuTime()),
    clock_(clockTime())
{}


Foam::ledger::section::~section()
{
    if (!ledger_.cpu_.found(name_))
    {
        ledger_.names_.append(name_);
        ledger_.cpu_.set(name_, 0);
        ledger_.clock_.set(name_, 0);
    }
    ledger_.cpu_[name_] += cpuTime() - cpu_;
    ledger_.clock_[name_] += clockTime() - clock_;
}


Foam::scalar Foam::ledger::cpuTime()
{
    return seconds(CLOCK_PROCESS_CPUTIME_ID);
}


Foam::scalar Foam::ledger::clockTime()
{
    return seconds(CLOCK_MONOTONIC);
}


void Foam::ledger::report(Ostream& os) const
{
    scalar cpu = 0;
    scalar clock = 0;
    for (const word& name : names_)
    {
        cpu += cpu_[name];
        clock += clock_[name];
    }

    const scalar allSteps = returnReduce(particleSteps_, sumOp<scalar>());
    const scalar allCpu = returnReduce(cpu, sumOp<scalar>());

    os  << "Ledger" << (Pstream::parRun() ? " of processor 0, totals of all" : "")
        << nl
        << "    section              CPU s     clock s   per cent  ns/particle-step"
        << "  million pairs/CPU s"
        << nl;
    for (const word& name : names_)
    {
        char line[128];
        std::snprintf
        (
            line, sizeof(line), "    %-16s %10.3f  %10.3f   %8.2f  %16.1f",
            name.c_str(),
            cpu_[name],
            clock_[name],
            100*cpu_[name]/max(cpu, VSMALL),
            1e9*cpu_[name]/max(particleSteps_, scalar(1))
        );
        os  << line;
        if (pairs_.found(name))
        {
            std::snprintf
            (
                line, sizeof(line), "  %19.1f",
                1e-6*pairs_[name]/max(cpu_[name], VSMALL)
            );
            os  << line;
        }
        os  << nl;
    }
    os  << "    steps " << nSteps_
        << ", particle-steps " << allSteps
        << ", particle-steps per CPU second "
        << allSteps/max(allCpu, VSMALL)
        << ", per clock second " << allSteps/max(clock, VSMALL) << nl;
}


// ************************************************************************* //
