/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphEnergy.H"
#include "energyBudget.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(ulphEnergy, 0);
    addToRunTimeSelectionTable(functionObject, ulphEnergy, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::ulphEnergy::ulphEnergy
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    ulphFunctionObject(name, runTime, dict, typeName)
{
    read(dict);
    start();
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::List<Foam::string> Foam::functionObjects::ulphEnergy::remarks() const
{
    return {"Energy of the particles [J]; from viscosity on since the start"};
}


Foam::wordList Foam::functionObjects::ulphEnergy::columns() const
{
    wordList names({"kinetic", "potential", "elastic", "total"});
    names.append(wordList(energyBudget::effectNames.names()));
    names.append("rest");
    return names;
}


Foam::scalarList Foam::functionObjects::ulphEnergy::row()
{
    const energyBudget& budget = energyBudget::New(mesh_);

    DynamicList<scalar> values;
    for (const scalar energy :
        {budget.kinetic(), budget.potential(), budget.elastic()})
    {
        values.append(returnReduce(energy, sumOp<scalar>()));
    }
    const scalar total = values[0] + values[1] + values[2];
    values.append(total);

    if (!started_)
    {
        started_ = true;
        first_ = total;
    }
    scalar rest = total - first_;
    for (const word& name : energyBudget::effectNames.names())
    {
        values.append(budget.work(energyBudget::effectNames[name]));
        rest -= values.last();
    }
    values.append(rest);
    return scalarList(values);
}


// ************************************************************************* //
