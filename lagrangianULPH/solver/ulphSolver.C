/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphSolver.H"

#include "fluidLattice.H"
#include "inputChecks.H"
#include "Time.H"

#include <omp.h>

// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::ulphSolver::meshObject(const Time& time)
{
    return IOobject
    (
        fvMesh::defaultRegion, time.timeName(), time, IOobject::MUST_READ
    );
}


void Foam::ulphSolver::refuseParallel(const int argc, char* const argv[])
{
    // Before argList asks for a decomposition that would not help
    for (int i = 1; i < argc; ++i)
    {
        if (string(argv[i]) == "-parallel")
        {
            FatalErrorInFunction
                << "ulphFoam does not run in parallel by MPI yet." << nl
                << "    Leave out mpirun and -parallel and use threads:"
                << " OMP_NUM_THREADS=2 ulphFoam"
                << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::ulphCloud::properties Foam::ulphSolver::shared
(
    const dictionary& dict,
    const kernel& weight,
    const scalar dx
)
{
    const word precision(dict.getOrDefault<word>("precision", "mixed"));
    if (precision != "mixed" && precision != "double")
    {
        FatalIOErrorInFunction(entryPlace(dict, "precision"))
            << "Unknown precision " << precision << nl << nl
            << "Valid precisions are" << nl
            << wordList({"double", "mixed"}) << nl
            << exit(FatalIOError);
    }

    ulphCloud::properties p;
    p.dx = dx;
    p.h = weight.h();
    p.rho0 = getInRange(dict, "rho0", scalarMinMax::ge(SMALL));
    p.c0 = getInRange(dict, "c0", scalarMinMax::ge(SMALL));
    p.beta = weight.latticeMoment();
    p.mixed = precision == "mixed";
    return p;
}


void Foam::ulphSolver::checkKeywords()
{
    wordList valid
    ({
        "mode", "dx", "rho0", "c0", "precision", "fields", "skin", "regions",
        "guard", "kernel", "hByDx"
    });
    for (const effect& e : models_.all())
    {
        valid.append(e.family());
    }
    refuseMisspelt(properties_, valid);
    warnOfUnknown(properties_, valid);

    wordList names({"U", "p", "rho"});
    names.append(cloud_.derivedNames());
    for
    (
        const wordRe& chosen
      : properties_.getOrDefault("fields", List<wordRe>())
    )
    {
        if (wordRes(1, chosen).matching(names).empty())
        {
            IOWarningInFunction(entryPlace(properties_, "fields"))
                << "No field to write is called " << chosen
                << " with the effects that are on" << nl << nl
                << "Valid fields are" << nl << flatOutput(names) << nl << endl;
        }
    }
}


void Foam::ulphSolver::refuseLostParticles() const
{
    for (const instant& earlier : time_.times())
    {
        if
        (
            earlier.value() < time_.value()
         && ulphCloud::found(mesh_, earlier.name())
        )
        {
            FatalErrorInFunction
                << "There are no particles in "
                << time_.timePath()/cloud::prefix/cloud_.name()
                << ", though there are in earlier times such as "
                << earlier.name() << '.' << nl
                << "    Remove the folder " << time_.timePath()
                << " and restart from the time before it."
                << exit(FatalError);
        }
    }
}


void Foam::ulphSolver::makeParticles()
{
    if (ulphCloud::found(mesh_, time_.timeName()))
    {
        cloud_.read(time_.timeName());

        // The name of the time directory is a rounded value
        time_.setTime
        (
            cloud_.readProperties(time_.timeName()).getOrDefault<scalar>
            (
                "time", time_.value()
            ),
            time_.timeIndex()
        );
        Info<< "Read " << cloud_.size() << " particles of time "
            << time_.timeName() << "; nothing is filled into regions" << nl
            << endl;
        return;
    }

    refuseLostParticles();

    const fluidLattice lattice(mesh_, search_, properties_);

    const label n = lattice.size();
    scalarField rho1(n);
    scalarField mass(n);
    for (label i = 0; i < n; ++i)
    {
        rho1[i] = models_.state->densityExcess(lattice.pressure()[i]);
        mass[i] = cloud_.rho0()*lattice.volume()[i];
    }
    cloud_.set(lattice.position(), lattice.velocity(), rho1, mass);

    Info<< "Filled " << n << " particles into " << lattice.regionNames().size()
        << " regions" << nl << endl;
}


void Foam::ulphSolver::limitThreads() const
{
    // With fewer, starting the threads takes longer than their work
    constexpr label particlesPerThread = 2000;

    const int useful = max(1, int(cloud_.size()/particlesPerThread));
    omp_set_num_threads(min(omp_get_max_threads(), useful));
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
        dt = min(dt, 0.125*sqr(h)/nu);
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
    wall_(cloud_, search_, *models_.boundary, *models_.force, *models_.state),
    neighbours_
    (
        cloud_,
        wall_,
        kernel_,
        getInRange(properties_, "skin", 0.2, scalarMinMax(0, 2))
    ),
    contact_(cloud_, search_),
    schedule_(models_, cloud_),
    guard_(properties_, cloud_, [this]() { writeCloud(); }),
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

    tools_.reset(new stepTools(rates_, contact_, guard_));
    tools_->setMaxAcceleration
    (
        cloud_.readProperties(time.timeName()).getOrDefault<scalar>
        (
            "maxAcceleration",
            cloud_.size()
          ? mag(models_.force->acceleration(cloud_.position(0), time.value()))
          : 0
        )
    );

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
        // restart takes from another start: in float it is the same
        time_.setDeltaT(scalar(float(time_.deltaTValue())), false);
    }
    guard_.checkDeltaT(time_.deltaTValue(), cloud_.h()/cloud_.c0());
}


void Foam::ulphSolver::evaluate()
{
    rates_.updateNeighbours();
    rates_.geometry(time_.value(), rightHandSide::laplacian::now);
    rates_.force(time_.value(), false);
}


void Foam::ulphSolver::advance()
{
    const scalar dt = time_.deltaTValue();
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
    const labelList cells(locator_.find(cloud_.positions()));
    DynamicList<label> escaped;
    forAll(cells, i)
    {
        if (cells[i] < 0)
        {
            escaped.append(i);
        }
    }
    if (escaped.size())
    {
        energyBudget::change work
        (
            energyBudget::find(mesh_),
            energyBudget::escape,
            &energyBudget::total
        );
        guard_.countEscaped(escaped);
        cloud_.remove(labelHashSet(escaped));
        neighbours_.invalidate();
    }
}


void Foam::ulphSolver::writeCloud() const
{
    dictionary extra;
    extra.add("time", time_.value());
    extra.add("maxAcceleration", tools_->maxAcceleration());
    cloud_.write(locator_, locator_.find(cloud_.positions()), extra);
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
    neighbours_.invalidate();
}


void Foam::ulphSolver::info() const
{
    const scalar perSpeed = time_.deltaTValue()/cloud_.h();
    Info<< "Courant Number mean: " << cloud_.c0()*perSpeed
        << " max: " << (cloud_.c0() + tools_->maxSpeed())*perSpeed << nl
        << "particles " << cloud_.size() << ", walls " << wall_.size()
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
        << "    fluid particles        " << cloud_.size() << nl
        << "    wall particles in reach " << wall_.size() << nl
        << "    sources listed per particle "
        << neighbours_.fluidList().meanListed() << nl
        << "    memory                 "
        << (cloud_.size()*scalar(cloud_.bytes()) + neighbours_.bytes())/1e6
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
        << ", lists made " << neighbours_.nBuilds() << " times" << nl
        << "    memory "
        << cloud_.bytes() << " bytes of fields and "
        << neighbours_.bytes()/scalar(max(cloud_.size(), label(1)))
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
