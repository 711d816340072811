/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudFiles.H"

#include "ulphCloud.H"
#include "OFstream.H"
#include "Time.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

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

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::writeChecked
(
    const regIOobject& object,
    const IOstream::streamFormat format,
    const unsigned precision
)
{
    const Time& time = object.time();
    const fileName path(object.objectPath());

    bool good = false;
    label line = 0;
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
        line = os.lineNumber();
        good = good && os.stdStream().good();
    }
    catch (const Foam::error&)
    {}

    if (!good)
    {
        removeCloud(time);

        FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, path, line)
            << "Cannot write " << path << nl
            << "    The disk may be full or the folder not writable. The "
            << "particles of this time are removed," << nl
            << "    times written before are intact: make room and restart "
            << "from the latest time."
            << exit(FatalIOError);
    }
}


void Foam::writeChecked(const regIOobject& object)
{
    writeChecked
    (
        object, object.time().writeFormat(), IOstream::defaultPrecision()
    );
}


Foam::IOobject Foam::cloudPropertiesObject
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


void Foam::stopAtDamage
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


// ************************************************************************* //
