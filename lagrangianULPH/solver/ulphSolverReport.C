/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphSolver.H"

#include "Time.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::ulphSolver::info() const
{
    const scalar perSpeed = time_.deltaTValue()/cloud_.h();
    Info<< "Courant Number mean: " << cloud_.c0()*perSpeed
        << " max: " << (cloud_.c0() + tools_->maxSpeed())*perSpeed << nl
        << "particles " << nParticles() << ", walls "
        << returnReduce(wall_.size(), sumOp<label>())
        << ", max(mag(U)) " << tools_->maxSpeed() << nl;

    const scalar done = time_.value() - startTime_;
    const scalar left = time_.endTime().value() - time_.value();
    if (done > 0 && left > 0)
    {
        Info<< "predicted finish in "
            << (ledger::clockTime() - startClock_)*left/done << " s" << nl;
    }
}


void Foam::ulphSolver::predict()
{
    // The second evaluation has its memory warm
    scalar seconds = 0;
    for (int i = 0; i < 2; ++i)
    {
        const scalar start = ledger::clockTime();
        neighbours_.invalidate();
        evaluate();
        seconds = ledger::clockTime() - start;
    }

    const scalar dt =
        time_.controlDict().getOrDefault("adjustTimeStep", false)
      ? stableDeltaT(maxCo())
      : time_.deltaTValue();
    const scalar steps = (time_.endTime().value() - time_.value())/dt;

    Info<< nl << "Prediction" << nl
        << "    fluid particles        " << nParticles() << nl
        << "    wall particles in reach "
        << returnReduce(wall_.size(), sumOp<label>()) << nl
        << "    sources listed per particle "
        << neighbours_.fluidList().meanListed() << nl
        << "    memory                 "
        << returnReduce
           (
               cloud_.size()*scalar(cloud_.bytes()) + neighbours_.bytes(),
               sumOp<scalar>()
           )/1e6
        << " MB" << nl
        << "    time step              " << dt << " s at the start" << nl
        << "    steps                  " << steps << nl
        << "    wall time              about "
        << steps*seconds*models_.integration->evaluationsPerStep()
        << " s" << nl << endl;
}


void Foam::ulphSolver::report() const
{
    Info<< nl;
    ledger_.report(Info);
    Info<< "    sources listed per particle "
        << neighbours_.fluidList().meanListed()
        << ", lists made " << neighbours_.nBuilds() << " times, renewed in part "
        << returnReduce(neighbours_.nRenewals(), maxOp<label>()) << " times" << nl
        << "    memory "
        << cloud_.bytes() << " bytes of fields and "
        << returnReduce(scalar(neighbours_.bytes()), sumOp<scalar>())
           /max(nParticles(), label(1))
        << " bytes of lists and records per particle" << nl
        << "Clamped, floored or removed" << nl;
    UPtrList<effect> effects(const_cast<ulphModels&>(models_).all());
    for (const effect& e : effects)
    {
        e.report(Info);
    }
    wall_.report(Info);
    contact_.report(Info);
    guard_.report(Info);
    Info<< endl;
}


// ************************************************************************* //
