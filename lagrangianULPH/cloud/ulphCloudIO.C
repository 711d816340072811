/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphCloud.H"

#include "cloudPositions.H"
#include "IOField.H"
#include "OFstream.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Write an object and make sure that it has reached the disk
static void writeChecked(const regIOobject& object)
{
    const Time& time = object.time();
    const fileName path(object.objectPath());
    mkDir(path.path());

    bool good = false;
    {
        OFstream os
        (
            path,
            time.writeFormat(),
            IOstream::currentVersion,
            time.writeCompression()
        );
        good = os.good() && object.writeHeader(os) && object.writeData(os);
        IOobject::writeEndDivider(os);
        os.stdStream().flush();
        good = good && os.stdStream().good();
    }
    if (!good)
    {
        FatalErrorInFunction
            << "Cannot write " << path << nl
            << "    The disk may be full or the folder not writable. Times "
            << "written before are intact;" << nl
            << "    remove this incomplete time directory, make room and "
            << "restart from the latest time."
            << exit(FatalError);
    }
}


template<class Type>
static IOField<Type> readField
(
    const cloud& registry,
    const word& name,
    const word& instance,
    const label n
)
{
    IOField<Type> field
    (
        IOobject
        (
            name, instance, registry, IOobject::MUST_READ, IOobject::NO_WRITE,
            false
        )
    );
    if (field.size() != n)
    {
        FatalErrorInFunction
            << "File " << field.objectPath() << " holds " << field.size()
            << " values for the " << n << " particles of positions." << nl
            << "    Restart from another time directory."
            << exit(FatalError);
    }
    return field;
}


static IOobject propertiesObject
(
    const fvMesh& mesh,
    const word& instance,
    const IOobject::readOption read
)
{
    return IOobject
    (
        "cloudProperties",
        instance,
        "uniform"/cloud::prefix/ulphCloud::cloudName,
        mesh.time(),
        read,
        IOobject::NO_WRITE,
        false
    );
}

} // End namespace Foam


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


bool Foam::ulphCloud::found(const fvMesh& mesh, const word& instance)
{
    return isFile
    (
        mesh.time().path()/instance/cloud::prefix/cloudName/"positions"
    )
     || isFile
    (
        mesh.time().path()/instance/cloud::prefix/cloudName/"positions.gz"
    );
}


void Foam::ulphCloud::read(const word& instance)
{
    pointField positions;
    labelList cells;
    cloudPositions(*this, instance, positions, cells).readAll();

    const label n = positions.size();
    const IOField<vector> U(readField<vector>(*this, "U", instance, n));
    const IOField<scalar> rho1
    (
        readField<scalar>(*this, "densityExcess", instance, n)
    );
    const IOField<scalar> m(readField<scalar>(*this, "mass", instance, n));
    const IOField<label> ids(readField<label>(*this, "origId", instance, n));

    forAll(positions, i)
    {
        const scalar sum = cmptSum(positions[i]) + cmptSum(U[i]) + rho1[i];
        if (!std::isfinite(sum) || !(m[i] > 0) || !(rho0() + rho1[i] > 0))
        {
            FatalErrorInFunction
                << "Particle " << i << " of time " << instance
                << " is not usable: position " << positions[i] << ", U "
                << U[i] << ", densityExcess " << rho1[i] << ", mass " << m[i]
                << nl
                << "    A file of " << U.path() << " is corrupt; "
                << "restart from another time directory."
                << exit(FatalError);
        }
    }

    set(positions, U, rho1, m);
    std::copy(ids.begin(), ids.end(), origId_.begin());
}


void Foam::ulphCloud::write
(
    const cellLocator& locator,
    const labelUList& cellOf,
    const dictionary& extra
) const
{
    labelList kept(size_);
    label n = 0;
    forAll(cellOf, i)
    {
        if (cellOf[i] >= 0)
        {
            kept[n++] = i;
        }
    }
    kept.resize(n);
    pointField written(positions(), kept);
    labelList cells(UIndirectList<label>(cellOf, kept)());

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
        writeChecked(IOField<scalar>(object(name), scalarField(values, kept)));
    };
    const auto writeVectors = [&](const word& name)
    {
        writeChecked
        (
            IOField<vector>(object(name), vectorField(vectors(name), kept))
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

    IOField<label> ids(object("origId"), n);
    IOField<label> procs(object("origProcId"), n);
    forAll(ids, i)
    {
        ids[i] = origId_[kept[i]];
        procs[i] = Pstream::myProcNo();
    }
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

    const IOdictionary properties
    (
        propertiesObject(mesh_, time().timeName(), IOobject::NO_READ), extra
    );
    const fileName path(properties.objectPath());
    mkDir(path.path());
    OFstream os(path);
    os.precision(17);
    properties.writeHeader(os);
    properties.writeData(os);
}


Foam::dictionary Foam::ulphCloud::readProperties(const word& instance) const
{
    IOobject object(propertiesObject(mesh_, instance, IOobject::MUST_READ));
    return
        object.typeHeaderOk<IOdictionary>(false)
      ? dictionary(IOdictionary(object))
      : dictionary();
}


// ************************************************************************* //
