/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphCloud.H"

#include "cloudPositions.H"
#include "inputChecks.H"
#include "IOField.H"
#include "OFstream.H"
#include "StringStream.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- While it lives, errors are exceptions
class errorsThrown
{
    const bool error_;

    const bool IOerror_;

public:

    errorsThrown()
    :
        error_(FatalError.throwExceptions()),
        IOerror_(FatalIOError.throwExceptions())
    {}

    ~errorsThrown()
    {
        FatalError.throwExceptions(error_);
        FatalIOError.throwExceptions(IOerror_);
    }
};


//- Remove what there is of the cloud in the present time directory, and that
//  directory itself if it has nothing else: a restart shall not find them
static void removeCloud(const Time& time)
{
    const fileName lagrangian(time.timePath()/cloud::prefix);
    const fileName uniform(time.timePath()/"uniform");

    rmDir(lagrangian/ulphCloud::cloudName);
    rmDir(uniform/cloud::prefix/ulphCloud::cloudName);

    // Only if empty
    std::remove(lagrangian.c_str());
    std::remove((uniform/cloud::prefix).c_str());
    std::remove(uniform.c_str());
    std::remove(time.timePath().c_str());
}


//- Write an object and make sure that it has reached the disk
static void writeChecked
(
    const regIOobject& object,
    const IOstream::streamFormat format,
    const unsigned precision
)
{
    const Time& time = object.time();
    const fileName path(object.objectPath());

    bool good = false;
    try
    {
        const errorsThrown guarded;
        mkDir(path.path());
        OFstream os
        (
            path,
            format,
            IOstream::currentVersion,
            time.writeCompression()
        );
        os.precision(precision);
        good = os.good() && object.writeHeader(os) && object.writeData(os);
        IOobject::writeEndDivider(os);
        os.stdStream().flush();
        good = good && os.stdStream().good();
    }
    catch (const Foam::error&)
    {}

    if (!good)
    {
        removeCloud(time);

        FatalErrorInFunction
            << "Cannot write " << path << nl
            << "    The disk may be full or the folder not writable. The "
            << "particles of this time are removed," << nl
            << "    times written before are intact: make room and restart "
            << "from the latest time."
            << exit(FatalError);
    }
}


static void writeChecked(const regIOobject& object)
{
    writeChecked
    (
        object, object.time().writeFormat(), IOstream::defaultPrecision()
    );
}


[[noreturn]] static void stopAtDamage
(
    const fileName& path,
    const label line,
    const string& what
)
{
    FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, path, line)
        << "The particles of a time to start from are damaged or not all "
        << "there:" << nl << "    " << what.c_str() << nl
        << "    Remove this time directory and restart from the one before."
        << exit(FatalIOError);

    ::abort();
}


//- Call a function that reads a file of the cloud, with clear errors
template<class Reader>
static auto readWhole(const fileName& path, const Reader& reader)
{
    label line = -1;
    string what;
    try
    {
        const errorsThrown guarded;
        return reader();
    }
    catch (const IOerror& err)
    {
        line = err.ioStartLineNumber();
        what = err.message();
    }
    catch (const Foam::error& err)
    {
        what = err.message();
    }
    stopAtDamage(path, line, what);
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
    const IOobject object
    (
        name, instance, registry, IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    const IOField<Type> field
    (
        readWhole
        (
            object.objectPath(), [&]() { return IOField<Type>(object); }
        )
    );
    if (field.size() != n)
    {
        stopAtDamage
        (
            field.objectPath(),
            -1,
            Foam::name(field.size()) + " values for the " + Foam::name(n)
          + " particles of positions"
        );
    }
    return field;
}


//- Comparing one that is not finite would trap
static bool finite(const vector& v)
{
    return
        std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
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


void Foam::ulphCloud::checkProperties
(
    const word& instance,
    const label n
) const
{
    // Written last: without it a time is not whole
    const dictionary written(readProperties(instance));
    const label nWritten = written.getOrDefault<label>("nParticles", -1);
    if (nWritten != n)
    {
        stopAtDamage
        (
            propertiesObject(mesh_, instance, IOobject::NO_READ).objectPath(),
            -1,
            nWritten < 0
          ? string("the number of particles is not there")
          : Foam::name(nWritten) + " particles, but " + Foam::name(n)
          + " in positions"
        );
    }

    const auto refuseChange = [&](const word& name, const scalar now)
    {
        const scalar then = written.getOrDefault<scalar>(name, now);
        if (mag(then - now) > 1e-6*mag(now))
        {
            FatalIOErrorInFunction(entryPlace(written, name))
                << "The particles of time " << instance << " were made for "
                << name << ' ' << then << ", but now it is " << now
                << " in constant/ulphProperties." << nl
                << "    Set it back, or start anew: foamListTimes -rm and "
                << "remove 0/" << cloud::prefix
                << exit(FatalIOError);
        }
    };
    refuseChange("dx", dx());
    refuseChange("rho0", rho0());
}


void Foam::ulphCloud::read(const word& instance)
{
    pointField positions;
    labelList cells;
    cloudPositions file(*this, instance, positions, cells);
    readWhole(file.objectPath(), [&]() { file.readAll(); });

    const label n = positions.size();
    checkProperties(instance, n);
    const IOField<vector> U(readField<vector>(*this, "U", instance, n));
    const IOField<scalar> rho1
    (
        readField<scalar>(*this, "densityExcess", instance, n)
    );
    const IOField<scalar> m(readField<scalar>(*this, "mass", instance, n));
    const IOField<label> ids(readField<label>(*this, "origId", instance, n));

    // Ascii rounds
    boundBox bounds(mesh_.bounds());
    bounds.inflate(1e-3);

    forAll(positions, i)
    {
        const char* const damaged =
            !finite(positions[i]) || !bounds.contains(positions[i])
          ? "positions"
          : !finite(U[i]) ? "U"
          : !std::isfinite(rho1[i]) || rho0() + rho1[i] <= 0
          ? "densityExcess"
          : !std::isfinite(m[i]) || m[i] <= 0 ? "mass"
          : nullptr;

        if (damaged)
        {
            OStringStream what;
            what<< "particle " << i << " has position " << positions[i]
                << ", U " << U[i] << ", densityExcess " << rho1[i]
                << ", mass " << m[i];
            stopAtDamage(U.path()/damaged, -1, what.str());
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

    // Last: without it a restart takes the time as not whole
    IOdictionary properties
    (
        propertiesObject(mesh_, time().timeName(), IOobject::NO_READ), extra
    );
    properties.add("nParticles", n);
    properties.add("dx", dx());
    properties.add("rho0", rho0());
    writeChecked(properties, IOstream::ASCII, 17);
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
