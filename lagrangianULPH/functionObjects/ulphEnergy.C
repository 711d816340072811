/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphEnergy.H"
#include "addToRunTimeSelectionTable.H"

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
    return {"Energy of the particles [J]; diffusion and rest since the start"};
}


Foam::wordList Foam::functionObjects::ulphEnergy::columns() const
{
    return
    {
        "kinetic", "potential", "elastic", "total", "diffusion", "rest"
    };
}


Foam::scalarList Foam::functionObjects::ulphEnergy::row()
{
    const ulphCloud& cloud = particles();
    const particleField& m = cloud.mass();
    const bodyForce& force = *models().force;
    const equationOfState& state = *models().state;
    const scalar t = time_.value();

    const scalar kinetic = sum([&](const label i)
    {
        return 0.5*m(i)*magSqr(cloud.toVector(cloud.v(), i));
    });
    const scalar potential = sum([&](const label i)
    {
        return m(i)*force.potential(cloud.position(i), t);
    });
    const scalar elastic = sum([&](const label i)
    {
        return m(i)*state.energy(cloud.densityExcess()(i));
    });
    const scalar total = kinetic + potential + elastic;

    if (!started_)
    {
        started_ = true;
        first_ = total;
    }
    return
    {
        kinetic, potential, elastic, total, diffusion_,
        total - first_ - diffusion_
    };
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::ulphEnergy::read(const dictionary& dict)
{
    return ulphFunctionObject::read(dict);
}


bool Foam::functionObjects::ulphEnergy::execute()
{
    const ulphCloud& cloud = particles();
    const equationOfState& state = *models().state;

    if (const particleField* const rate = cloud.derived("densityDiffusion"))
    {
        diffusion_ += time_.deltaTValue()*sum([&](const label i)
        {
            const scalar rho1 = cloud.densityExcess()(i);
            return
                cloud.mass()(i)*state.pressure(rho1)*(*rate)(i)
               /sqr(cloud.rho0() + rho1);
        });
    }
    return true;
}


// ************************************************************************* //
