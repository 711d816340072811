/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphSolver.H"

#include "fluidLattice.H"
#include "inputChecks.H"
#include "meshPlaces.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "fvMesh.H"

#include <omp.h>

// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::ulphSolver::meshObject(const Time& time)
{
    return IOobject
    (
        fvMesh::defaultRegion, time.timeName(), time, IOobject::MUST_READ
    );
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::ulphSolver::limitThreads() const
{
    // With fewer, starting the threads takes longer than their work
    constexpr label particlesPerThread = 2000;

    const label share = nParticles()/Pstream::nProcs();
    const int useful = max(1, int(share/particlesPerThread));
    omp_set_num_threads(min(omp_get_max_threads(), useful));
}


Foam::label Foam::ulphSolver::nParticles() const
{
    return returnReduce(cloud_.size(), sumOp<label>());
}


Foam::scalar Foam::ulphSolver::maxCo() const
{
    return getInRange
    (
        time_.controlDict(),
        "maxCo",
        models_.integration->defaultMaxCo(),
        scalarMinMax::ge(SMALL)
    );
}


Foam::scalar Foam::ulphSolver::stableDeltaT(const scalar maxCo) const
{
    const scalar h = cloud_.h();

    scalar dt = maxCo*h/(cloud_.c0() + tools_->maxSpeed());
    if (tools_->maxAcceleration() > 0)
    {
        dt = min(dt, maxCo*std::sqrt(h/tools_->maxAcceleration()));
    }
    const scalar nu = models_.viscous->nu(cloud_);
    if (nu > 0)
    {
        // A quarter of what a particle among others stands: no-slip walls and
        // surfaces make it twice as stiff
        dt = min(dt, 0.0625*sqr(h)/nu);
    }
    return dt;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::ulphSolver::ulphSolver(Time& time, const fvMesh& mesh)
:
    time_(time),
    mesh_(mesh),
    properties_
    (
        IOobject
        (
            "ulphProperties",
            time.constant(),
            time,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    dx_(fluidLattice::spacing(properties_, mesh)),
    kernel_(properties_, mesh.nGeometricD(), dx_),
    cloud_
    (
        mesh,
        shared(properties_, kernel_, dx_),
        wordRes
        (
            properties_.getOrDefault
            (
                "fields",
                List<wordRe>
                (
                    1, wordRe("p|rho|lambda|surface|normal", wordRe::REGEX)
                )
            )
        )
    ),
    models_(properties_, cloud_),
    search_(mesh),
    locator_(mesh),
    motion_(properties_, mesh),
    bodies_(properties_, search_, dx_),
    wall_
    (
        cloud_,
        bodies_,
        *models_.boundary,
        *models_.force,
        motion_,
        *models_.state
    ),
    neighbours_
    (
        cloud_,
        wall_,
        kernel_,
        getInRange(properties_, "skin", 0.2, scalarMinMax(0, 2))
    ),
    contact_(cloud_, bodies_),
    load_(mesh, cloud_, models_, wall_, neighbours_),
    schedule_(models_, cloud_),
    guard_(properties_, cloud_, [this]() { return writeLastGood(); }),
    rates_
    (
        cloud_, models_, schedule_, wall_, neighbours_, contact_, ledger_
    ),
    startClock_(ledger::clockTime()),
    startTime_(time.value())
{
    cloud_.setPressure
    (
        [this](const scalar rho1) { return models_.state->pressure(rho1); }
    );
    checkKeywords();
    makeParticles();

    limitThreads();

    tools_.reset(new stepTools(rates_, contact_, motion_, guard_));
    const dictionary written(cloud_.readProperties(time.timeName()));
    tools_->setDensityLag(written.getOrDefault<scalar>("densityLag", 0));
    neighbours_.setSkin(written.getOrDefault<scalar>("skin", GREAT));
    tools_->setMaxAcceleration
    (
        written.getOrDefault<scalar>
        (
            "maxAcceleration",
            returnReduce
            (
                cloud_.size()
              ? mag(models_.force->at(time.value())(cloud_.position(0)))
              : 0,
                maxOp<scalar>()
            )
        )
    );

    if (!cloud_.savedKnown())
    {
        evaluate();
        cloud_.setSavedKnown(true);
    }

    schedule::print(models_, cloud_, Info);
    Info<< "Threads " << omp_get_max_threads() << nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::ulphSolver::setDeltaT()
{
    if (time_.controlDict().getOrDefault("adjustTimeStep", false))
    {
        time_.setDeltaT
        (
            min
            (
                stableDeltaT(maxCo()),
                getInRange
                (
                    time_.controlDict(),
                    "maxDeltaT",
                    GREAT,
                    scalarMinMax::ge(SMALL)
                )
            )
        );

        // The step to a write time comes from differences of times that a
        // restart takes from another start: in float it is the same. A little more,
        // as halfway between two floats is where such steps often are.
        time_.setDeltaT
        (
            scalar(float((1 + 1e-8)*time_.deltaTValue())), false
        );
    }
    guard_.checkDeltaT(time_.deltaTValue(), cloud_.h()/cloud_.c0());
}


void Foam::ulphSolver::evaluate()
{
    rates_.forgetDivergence();
    rates_.updateNeighbours(time_.value());
    rates_.geometry(time_.value());
    rates_.findSurface();
    rates_.force(time_.value(), time_.value(), false);
}


void Foam::ulphSolver::advance()
{
    const scalar dt = time_.deltaTValue();
    tools_->keep(dt);
    models_.integration->advance(*tools_, time_.value() - dt, dt);
    tools_->finish();
    if (!neighbours_.contains())
    {
        removeEscaped();
    }
    ledger_.addStep(cloud_.size());
}


void Foam::ulphSolver::removeEscaped()
{
    neighbours_.wrap();
    const meshPlaces places(mesh_, locator_, cloud_.positions());
    const labelUList& escaped = places.nowhere();
    if (returnReduce(escaped.size(), sumOp<label>()))
    {
        energyBudget::change work
        (
            energyBudget::find(mesh_),
            energyBudget::escape,
            &energyBudget::total
        );
        guard_.countEscaped(escaped);
        cloud_.remove(labelHashSet(escaped));
        contact_.clear();
        neighbours_.invalidate();
    }
}


void Foam::ulphSolver::writeCloud() const
{
    dictionary extra;
    extra.add("time", time_.value());
    extra.add("maxAcceleration", tools_->maxAcceleration());
    extra.add("densityLag", tools_->densityLag());
    extra.add("skin", neighbours_.nextSkin());
    if (time_.timeIndex() == 0)
    {
        extra.add("regions", regionsDigest());
    }
    cloud_.write
    (
        locator_, meshPlaces(mesh_, locator_, cloud_.positions()), extra
    );
}


bool Foam::ulphSolver::writeLastGood()
{
    const bool kept = tools_ && tools_->restore();
    if (kept)
    {
        time_.setTime
        (
            time_.value() - time_.deltaTValue(), time_.timeIndex() - 1
        );
    }
    // A restart evaluates it anew
    cloud_.setSavedKnown(false);
    neighbours_.wrap();
    writeCloud();
    return kept;
}


void Foam::ulphSolver::write(const bool always)
{
    if (!always && !time_.writeTime())
    {
        return;
    }
    ledger::section timer(ledger_, "write");

    removeEscaped();
    writeCloud();

    // A restart from here makes new lists: so must this run, to stay the same
    contact_.clear();
    neighbours_.invalidate();
}


// ************************************************************************* //
