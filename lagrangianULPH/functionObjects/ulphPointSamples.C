/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphPointSamples.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::ulphPointSamples::ulphPointSamples
(
    const word& name,
    const Time& runTime,
    const dictionary& dict,
    const word& tableName
)
:
    ulphFunctionObject(name, runTime, dict, tableName),
    cyclic_(mesh_)
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::ulphPointSamples::readPoints
(
    const dictionary& dict,
    const word& keyword
)
{
    dict.readEntry(keyword, points_);

    const ulphCloud& cloud = particles();
    const kernel weight(models().dict, cloud.D(), cloud.dx());
    weights_ = weight.sums(false);
    reach_ = 2*weight.h();
}


Foam::List<Foam::string>
Foam::functionObjects::ulphPointSamples::remarks() const
{
    List<string> lines(1, title());
    forAll(points_, i)
    {
        OStringStream os;
        os << pointName() << ' ' << i << ' ' << points_[i];
        lines.append(os.str());
    }
    return lines;
}


Foam::wordList Foam::functionObjects::ulphPointSamples::columns() const
{
    wordList names;
    forAll(points_, i)
    {
        for (const word& quantity : quantities())
        {
            names.append(quantity + '_' + Foam::name(i));
        }
    }
    return names;
}


Foam::scalarList Foam::functionObjects::ulphPointSamples::row()
{
    scalarList values;
    for (const point& where : points_)
    {
        values.append(valuesAt(where));
    }
    return values;
}


// ************************************************************************* //
