/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphCloud.H"

#include "cloudFiles.H"
#include "cloudPositions.H"
#include "inputChecks.H"
#include "joinProcessors.H"
#include "StringStream.H"
#include "Time.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Comparing one that is not finite would trap
static bool finite(const vector& v)
{
    return
        std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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
            cloudPropertiesObject(mesh_, instance, IOobject::NO_READ).objectPath(),
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
    refuseChange("c0", c0());
}


Foam::pointField Foam::ulphCloud::readPositions
(
    const word& instance,
    const cellLocator& locator
) const
{
    pointField positions;
    labelList cells;
    for
    (
        const auto geometry :
        {cloud::geometryType::COORDINATES, cloud::geometryType::POSITIONS}
    )
    {
        if (!cloudPositions::found(time(), instance, geometry))
        {
            continue;
        }
        pointField found;
        labelList at;
        cloudPositions file(*this, instance, geometry, locator, found, at);
        readWhole(file.objectPath(), [&]() { file.readAll(); });

        // reconstructPar writes coordinates alone, in an order of its own
        if (cells.size() && cells != at)
        {
            stopAtDamage
            (
                file.objectPath(), -1,
                "positions and coordinates do not have the same particles in the "
                "same order.\n    Remove positions if reconstructPar has written "
                "the others"
            );
        }
        // Those of positions are exact
        positions = found;
        cells = at;
    }
    return positions;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::ulphCloud::found(const fvMesh& mesh, const word& instance)
{
    return returnReduce
    (
        cloudPositions::found(mesh.time(), instance), orOp<bool>()
    );
}


Foam::dictionary Foam::ulphCloud::readProperties(const word& instance) const
{
    // decomposePar leaves out the time where a processor has no particle
    IOobject object(cloudPropertiesObject(mesh_, instance, IOobject::MUST_READ));
    dictionary own;
    stringList text;
    if (object.typeHeaderOk<IOdictionary>(false))
    {
        own = IOdictionary(object);
        OStringStream os;
        os.precision(17);
        own.write(os, false);
        text.append(os.str());
    }
    const stringList all(joinProcessors(text));
    return text.empty() && all.size() ? dictionary(IStringStream(all[0])()) : own;
}


void Foam::ulphCloud::read(const word& instance, const cellLocator& locator)
{
    const pointField positions(readPositions(instance, locator));
    const label n = positions.size();
    checkProperties(instance, returnReduce(n, sumOp<label>()));
    if (Pstream::parRun() && !cloudPositions::found(time(), instance))
    {
        set(positions, vectorField(), scalarField(), scalarField());
        savedKnown_ = returnReduce(true, andOp<bool>());
        return;
    }
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
    savedKnown_ = true;
    for (const word& name : saved_)
    {
        // Not written under other models: then it is not known yet
        if (!isFile(U.path()/name) && !isFile(U.path()/name + ".gz"))
        {
            savedKnown_ = false;
            break;
        }
        const IOField<scalar> values
        (
            readField<scalar>(*this, name, instance, n)
        );
        forAll(values, i)
        {
            if (!std::isfinite(values[i]))
            {
                stopAtDamage
                (
                    values.objectPath(), -1,
                    "particle " + Foam::name(i) + " has " + Foam::name(values[i])
                );
            }
            state_[name]->set(i, 0, values[i]);
        }
    }
    savedKnown_ = returnReduce(savedKnown_, andOp<bool>());
    std::copy(ids.begin(), ids.end(), origId_.begin());
}


// ************************************************************************* //
