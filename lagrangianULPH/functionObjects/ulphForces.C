/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphForces.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"
#include "wallLoad.H"
#include "wallPolyPatch.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(ulphForces, 0);
    addToRunTimeSelectionTable(functionObject, ulphForces, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::ulphForces::writeHead
(
    Ostream& os,
    const word& what
) const
{
    writeHeader(os, what);
    writeHeaderValue(os, "CofR", origin_);
    writeHeader(os, "");
    writeCommented(os, "Time");
    for (const char* const part : {"total", "pressure", "viscous"})
    {
        const word name(part);
        writeTabbed(os, '(' + name + "_x " + name + "_y " + name + "_z)");
    }
    os  << endl;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::functionObjects::ulphForces::columns() const
{
    wordList all;
    for
    (
        const char* const name :
        {
            "force", "pressureForce", "viscousForce",
            "moment", "pressureMoment", "viscousMoment"
        }
    )
    {
        for (const char* const cmpt : {"_x", "_y", "_z"})
        {
            all.append(word(name) + cmpt);
        }
    }
    return all;
}


Foam::scalarList Foam::functionObjects::ulphForces::row()
{
    const wallLoad& walls =
        mesh_.lookupObject<wallLoad>(wallLoad::typeName);
    if (!walls.known())
    {
        return {};
    }

    vector pressure(Zero), viscous(Zero);
    vector pressureMoment(Zero), viscousMoment(Zero);
    for (const wallLoad::load& load : walls.evaluate(patches_))
    {
        const vector arm(load.where - origin_);
        pressure += load.pressure;
        viscous += load.viscous;
        pressureMoment += arm ^ load.pressure;
        viscousMoment += arm ^ load.viscous;
    }
    for
    (
        vector* const part :
        {&pressure, &viscous, &pressureMoment, &viscousMoment}
    )
    {
        reduce(*part, sumOp<vector>());
    }

    scalarList values;
    for
    (
        const vector& part :
        {
            vector(pressure + viscous), pressure, viscous,
            vector(pressureMoment + viscousMoment), pressureMoment, viscousMoment
        }
    )
    {
        for (const scalar cmpt : {part.x(), part.y(), part.z()})
        {
            values.append(cmpt);
        }
    }
    return values;
}


void Foam::functionObjects::ulphForces::writeRow
(
    const wordList&,
    const scalarList& values
)
{
    if (!momentFile_)
    {
        momentFile_ = createFile("moment");
        writeHead(file(), "Force");
        writeHead(*momentFile_, "Moment");
    }
    label next = 0;
    for (Ostream* const os : std::initializer_list<Ostream*>{&file(), &*momentFile_})
    {
        writeCurrentTime(*os);
        for (label part = 0; part < 3; ++part)
        {
            const scalar* const cmpt = &values[next];
            *os << tab << vector(cmpt[0], cmpt[1], cmpt[2]);
            next += 3;
        }
        *os << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::ulphForces::ulphForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    ulphFunctionObject(name, runTime, dict, "force")
{
    read(dict);
    start();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::ulphForces::read(const dictionary& dict)
{
    dict.readEntry("patches", names_);
    origin_ = dict.getOrDefault<point>("CofR", Zero);

    wordList walls;
    patches_.clear();
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<wallPolyPatch>(patch))
        {
            walls.append(patch.name());
            if (names_.match(patch.name()))
            {
                patches_.insert(patch.index());
            }
        }
    }
    for (const wordRe& name : names_)
    {
        if (findStrings(name, walls).empty())
        {
            FatalIOErrorInFunction(entryPlace(dict, "patches"))
                << "No wall patch is called " << name << nl << nl
                << "Valid patches are" << nl
                << walls << nl
                << exit(FatalIOError);
        }
    }
    return ulphFunctionObject::read(dict);
}


// ************************************************************************* //
