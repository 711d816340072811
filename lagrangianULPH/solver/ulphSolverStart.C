/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphSolver.H"

#include "fluidLattice.H"
#include "inputChecks.H"
#include "Time.H"

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
        "guard", "kernel", "hByDx", "wallMotion"
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


Foam::string Foam::ulphSolver::regionsDigest() const
{
    return properties_.subOrEmptyDict("regions").digest().str();
}


void Foam::ulphSolver::refuseOtherRegions(const dictionary& written) const
{
    const string now(regionsDigest());
    if (written.getOrDefault<string>("regions", now) != now)
    {
        FatalIOErrorInFunction(entryPlace(properties_, "regions"))
            << "There are particles of time " << time_.timeName()
            << ", made for other regions than these." << nl
            << "    Remove the folder "
            << time_.timePath()/cloud::prefix/cloud_.name()
            << " to have these filled, or set them back."
            << exit(FatalIOError);
    }
}


void Foam::ulphSolver::makeParticles()
{
    if (ulphCloud::found(mesh_, time_.timeName()))
    {
        cloud_.read(time_.timeName(), locator_);
        const dictionary written(cloud_.readProperties(time_.timeName()));
        refuseOtherRegions(written);

        // The name of the time directory is a rounded value
        time_.setTime
        (
            written.getOrDefault<scalar>("time", time_.value()),
            time_.timeIndex()
        );
        Info<< "Read " << nParticles() << " particles of time "
            << time_.timeName() << "; nothing is filled into regions" << nl
            << endl;
        return;
    }

    refuseLostParticles();
    bodies_.refuseDisplaced(time_.value());

    const fluidLattice lattice(mesh_, search_, properties_);

    // All processors have made the same
    const label nAll = lattice.size();
    const label n = Pstream::master() ? nAll : 0;
    scalarField rho1(n);
    scalarField mass(n);
    for (label i = 0; i < n; ++i)
    {
        rho1[i] = models_.state->densityExcess(lattice.pressure()[i]);
        mass[i] = (cloud_.rho0() + rho1[i])*lattice.volume()[i];
    }
    cloud_.set
    (
        SubList<point>(lattice.position(), n),
        SubList<vector>(lattice.velocity(), n),
        rho1,
        mass
    );

    Info<< "Filled " << nAll << " particles into " << lattice.regionNames().size()
        << " regions" << nl << endl;
}


// ************************************************************************* //
