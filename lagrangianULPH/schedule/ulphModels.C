/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphModels.H"

#include "inputChecks.H"
#include "IOobject.H"
#include "IStringStream.H"
#include "wallPolyPatch.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(ulphModels, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool hasGravity(const polyMesh& mesh)
{
    IOobject header
    (
        "g", mesh.time().constant(), mesh.time(), IOobject::MUST_READ
    );
    return header.typeHeaderOk<IOdictionary>(false);
}


static const char* const defaultMode =
    "equationOfState    linear;"
    "momentMatrix       { type eigenvalueFloored; floor 0.5; }"
    "freeSurface        momentMatrix;"
    "shifting           { type Fickian; C 2; }"
    "wall               slip;"
    "timeIntegration    driftKickDrift;";

static const char* const paperMode =
    "equationOfState    linear;"
    "momentMatrix       optimal;"
    "freeSurface        momentMatrix;"
    "densityDiffusion   { type ULPH; delta 0.1; }"
    "densityRelaxation  none;"
    "shifting           { type XuStansbyLaurence; C 0.04; }"
    "viscosity          { type artificial; alpha 0.1; symmetric no; }"
    "wall               slip;"
    "timeIntegration    { type predictorCorrector; frozenGeometry no; }";

static const char* const stillWalls =
    "viscosity          { type artificial; alpha 0.002; }";

static const char* const inviscid =
    "viscosity          none;";

static const char* const heavy =
    "densityDiffusion   { type hydrostatic; delta 0.1; }"
    "densityRelaxation  { type moment; k 0.005; }";

static const char* const weightless =
    "densityDiffusion   { type ULPH; delta 0.1; }"
    "densityRelaxation  none;";

//- Of the type that the mode has, coefficients that are not given are the mode's
static void addCoefficients(const entry& model, dictionary& all)
{
    const word& family = model.keyword();
    const word type(model.dict().get<word>("type"));
    if (!all.isDict(family))
    {
        if (all.get<word>(family) == type)
        {
            all.set(model);
        }
        return;
    }
    dictionary& chosen = all.subDict(family);
    if (chosen.getOrDefault<word>("type", word::null) == type)
    {
        for (const entry& coefficient : model.dict())
        {
            if (!chosen.found(coefficient.keyword()))
            {
                chosen.add(coefficient);
            }
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::ulphModels::ulphModels
(
    const dictionary& ulphProperties,
    const ulphCloud& cloud
)
:
    regIOobject
    (
        IOobject
        (
            typeName,
            cloud.mesh().time().constant(),
            cloud.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    dict(complete(ulphProperties, cloud.mesh())),
    state(equationOfState::New(dict, cloud)),
    moment(momentMatrix::New(dict, cloud)),
    surface(freeSurface::New(dict, cloud)),
    diffusion(densityDiffusion::New(dict, cloud)),
    relaxation(densityRelaxation::New(dict, cloud)),
    shift(shifting::New(dict, cloud)),
    viscous(viscosity::New(dict, cloud)),
    force(bodyForce::New(dict, cloud)),
    boundary(wall::New(dict, cloud, *viscous)),
    integration(timeIntegration::New(dict, cloud))
{
    if (moment->needsSurface() && surface->off())
    {
        FatalIOErrorInFunction(entryPlace(ulphProperties, "freeSurface"))
            << "momentMatrix " << moment->model()
            << " depends on the free surface, but freeSurface is none." << nl
            << "    Set freeSurface momentMatrix; or choose another "
            << "momentMatrix, for instance eigenvalueFloored."
            << exit(FatalIOError);
    }
}


Foam::dictionary Foam::ulphModels::complete
(
    const dictionary& ulphProperties,
    const polyMesh& mesh
)
{
    const word mode(ulphProperties.getOrDefault<word>("mode", "default"));

    dictionary all(ulphProperties);
    const auto fill = [&](const char* const entries)
    {
        const dictionary defaults((IStringStream(entries)()));
        for (const entry& e : defaults)
        {
            const word& family = e.keyword();
            if (!all.found(family))
            {
                all.add(e);
            }
            else if (e.isDict())
            {
                addCoefficients(e, all);
            }
        }
    };

    if (mode == "default")
    {
        fill(defaultMode);
        fill(mesh.boundaryMesh().findPatchIDs<wallPolyPatch>().size() ? stillWalls : inviscid);
        fill(hasGravity(mesh) ? heavy : weightless);
    }
    else if (mode == "paper")
    {
        fill(paperMode);
    }
    else
    {
        FatalIOErrorInFunction(entryPlace(ulphProperties, "mode"))
            << "Unknown mode " << mode << nl << nl
            << "Valid modes are" << nl
            << wordList({"default", "paper"}) << nl
            << exit(FatalIOError);
    }
    fill(hasGravity(mesh) ? "bodyForce gravity;" : "bodyForce none;");

    return all;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::UPtrList<Foam::effect> Foam::ulphModels::all()
{
    effect* const models[] =
    {
        state.get(), moment.get(), surface.get(), diffusion.get(),
        relaxation.get(), shift.get(), viscous.get(), force.get(),
        boundary.get(), integration.get()
    };

    UPtrList<effect> list(label(std::size(models)));
    forAll(list, i)
    {
        list.set(i, models[i]);
    }
    return list;
}


bool Foam::ulphModels::writeData(Ostream& os) const
{
    dict.write(os, false);
    return os.good();
}


// ************************************************************************* //
