/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphFunctionObject.H"
#include "inputChecks.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::ulphFunctionObject::ulphFunctionObject
(
    const word& name,
    const Time& runTime,
    const dictionary& dict,
    const word& tableName
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, tableName, dict)
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

bool Foam::functionObjects::ulphFunctionObject::found() const
{
    return mesh_.foundObject<ulphCloud>(ulphCloud::cloudName);
}


const Foam::ulphCloud&
Foam::functionObjects::ulphFunctionObject::particles() const
{
    return mesh_.lookupObject<ulphCloud>(ulphCloud::cloudName);
}


const Foam::ulphModels&
Foam::functionObjects::ulphFunctionObject::models() const
{
    return mesh_.lookupObject<ulphModels>(ulphModels::typeName);
}


Foam::vector Foam::functionObjects::ulphFunctionObject::unitDirection
(
    const dictionary& dict,
    const word& keyword,
    const vector& along
) const
{
    const ulphCloud& cloud = particles();
    vector solved(Zero);
    for (int k = 0; k < cloud.D(); ++k)
    {
        solved[cloud.axis(k)] = along[cloud.axis(k)];
    }
    if (mag(along) < SMALL || mag(solved - along) > SMALL*mag(along))
    {
        FatalIOErrorInFunction(entryPlace(dict, keyword))
            << "The direction " << keyword << ' ' << along
            << " is no direction of the " << cloud.D()
            << "-dimensional flow." << nl
            << "    Give one that is not zero and not along an empty patch, "
            << "for instance: " << keyword << " (0 1 0);"
            << exit(FatalIOError);
    }
    return along/mag(along);
}


void Foam::functionObjects::ulphFunctionObject::start()
{
    if (time_.timeIndex() == time_.startTimeIndex() && found())
    {
        write();
    }
}


void Foam::functionObjects::ulphFunctionObject::writeRow
(
    const wordList& names,
    const scalarList& values
)
{
    if (!headerWritten_)
    {
        for (const string& remark : remarks())
        {
            writeHeader(file(), remark);
        }
        writeCommented(file(), "Time");
        for (const word& column : names)
        {
            writeTabbed(file(), column);
        }
        file() << endl;
        headerWritten_ = true;
    }
    writeCurrentTime(file());
    for (const scalar value : values)
    {
        file() << tab << setw(charWidth()) << value;
    }
    file() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::ulphFunctionObject::read(const dictionary& dict)
{
    return fvMeshFunctionObject::read(dict) && writeFile::read(dict);
}


bool Foam::functionObjects::ulphFunctionObject::execute()
{
    return true;
}


bool Foam::functionObjects::ulphFunctionObject::write()
{
    const wordList names(columns());
    const scalarList values(row());
    if (values.empty())
    {
        return true;
    }

    Log << type() << ' ' << name() << " write:" << nl;
    forAll(names, i)
    {
        setResult(names[i], values[i]);
        Log << "    " << names[i] << " = " << values[i] << nl;
    }
    Log << endl;

    if (writeToFile())
    {
        writeRow(names, values);
    }
    return true;
}


// ************************************************************************* //
