/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphCloud.H"

#include "cloudFiles.H"
#include "cloudPositions.H"
#include "meshPlaces.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::ulphCloud::outputNames() const
{
    wordList names({"U", "p", "rho"});
    names.append(derivedNames());

    wordList chosen;
    for (const word& name : names)
    {
        if (name != "U" && written_.match(name))
        {
            chosen.append(name);
        }
    }
    return chosen;
}


bool Foam::ulphCloud::isVector(const word& name) const
{
    const particleField* const field = derived(name);
    return field && field->nComponents() == D();
}


Foam::scalarField Foam::ulphCloud::scalars(const word& name) const
{
    scalarField values(size_);
    const particleField* const field = derived(name);
    forAll(values, i)
    {
        const scalar rho1 = densityExcess()(i);
        values[i] =
            field ? (*field)(i)
          : name == "p" ? pressure_(rho1)
          : rho0() + rho1;
    }
    return values;
}


Foam::vectorField Foam::ulphCloud::vectors(const word& name) const
{
    vectorField values(size_);
    const particleField* const field = derived(name);
    forAll(values, i)
    {
        values[i] = toVector(field ? *field : v(), i);
    }
    return values;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::ulphCloud::writeObjects(objectRegistry& obr) const
{
    IOField<point>& positions(createIOField<point>("position", size_, obr));
    forAll(positions, i)
    {
        positions[i] = position(i);
    }
    createIOField<vector>("U", size_, obr) = vectors("U");
    for (const word& name : outputNames())
    {
        if (isVector(name))
        {
            createIOField<vector>(name, size_, obr) = vectors(name);
        }
        else if (name == "p" || name == "rho" || derived(name)->nComponents() == 1)
        {
            createIOField<scalar>(name, size_, obr) = scalars(name);
        }
    }
}


void Foam::ulphCloud::write
(
    const cellLocator& locator,
    const meshPlaces& places,
    const dictionary& extra
) const
{
    pointField written(places.distributed(positions()));
    labelList cells(places.cells());

    for
    (
        const auto geometry :
        {cloud::geometryType::COORDINATES, cloud::geometryType::POSITIONS}
    )
    {
        writeChecked
        (
            cloudPositions(*this, geometry, locator, written, cells)
        );
    }

    const auto object = [&](const word& name)
    {
        return IOobject
        (
            name, time().timeName(), *this, IOobject::NO_READ,
            IOobject::NO_WRITE, false
        );
    };
    const auto writeScalars = [&](const word& name, const scalarField& values)
    {
        writeChecked(IOField<scalar>(object(name), places.distributed(values)));
    };
    const auto writeVectors = [&](const word& name)
    {
        writeChecked
        (
            IOField<vector>(object(name), places.distributed(vectors(name)))
        );
    };

    writeVectors("U");
    writeScalars
    (
        "densityExcess",
        scalarField(UList<scalar>(const_cast<double*>(densityExcess().component(0)), size_))
    );
    writeScalars
    (
        "mass",
        scalarField(UList<scalar>(const_cast<double*>(mass().component(0)), size_))
    );

    for (const word& name : savedKnown_ ? saved_ : wordList())
    {
        scalarField values(size_);
        forAll(values, i)
        {
            values[i] = (*state_[name])(i);
        }
        writeScalars(name, values);
    }

    // Numbers are those of all processors
    const IOField<label> ids
    (
        object("origId"),
        places.distributed(UList<label>(const_cast<label*>(origId_.data()), size_))
    );
    const IOField<label> procs(object("origProcId"), labelField(ids.size(), Zero));
    writeChecked(ids);
    writeChecked(procs);

    for (const word& name : outputNames())
    {
        if (isVector(name))
        {
            writeVectors(name);
        }
        else if (!derived(name) || derived(name)->nComponents() == 1)
        {
            writeScalars(name, scalars(name));
        }
    }

    // Last: without it a restart takes the time as not whole
    IOdictionary properties
    (
        cloudPropertiesObject(mesh_, time().timeName(), IOobject::NO_READ), extra
    );
    properties.add("nParticles", returnReduce(ids.size(), sumOp<label>()));
    properties.add("dx", dx());
    properties.add("rho0", rho0());
    properties.add("c0", c0());
    writeChecked(properties, IOstream::ASCII, 17);
}


// ************************************************************************* //
