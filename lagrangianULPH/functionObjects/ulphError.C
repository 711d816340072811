/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphError.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(ulphError, 0);
    addToRunTimeSelectionTable(functionObject, ulphError, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Sums for the norms of one quantity
struct errorSums
{
    scalar volume = 0;

    scalar first = 0;

    scalar second = 0;

    scalar largest = 0;

    //- Of the exact value
    scalar exact = 0;

    //- Add a particle of volume V with an error and an exact value
    void add(const scalar V, const scalar error, const scalar value)
    {
        volume += V;
        first += V*error;
        second += V*sqr(error);
        largest = max(largest, error);
        exact += V*sqr(value);
    }

    //- L1, L2, Linf, rms of the exact value; over all processors
    scalarList norms() const
    {
        const scalar V = max(returnReduce(volume, sumOp<scalar>()), VSMALL);
        return
        {
            returnReduce(first, sumOp<scalar>())/V,
            std::sqrt(returnReduce(second, sumOp<scalar>())/V),
            returnReduce(largest, maxOp<scalar>()),
            std::sqrt(returnReduce(exact, sumOp<scalar>())/V)
        };
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::ulphError::ulphError
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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::functionObjects::ulphError::pressureLevel() const
{
    if (!exact_->relativePressure())
    {
        return 0;
    }
    const ulphCloud& cloud = particles();
    const auto volume = [&](const label i)
    {
        return cloud.mass()(i)/(cloud.rho0() + cloud.densityExcess()(i));
    };
    const auto error = [&](const label i)
    {
        return
            models().state->pressure(cloud.densityExcess()(i))
          - exact_->p(cloud.position(i));
    };
    return
        sum([&](const label i) { return volume(i)*error(i); })
       /max(sum(volume), VSMALL);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::List<Foam::string> Foam::functionObjects::ulphError::remarks() const
{
    return {"Errors against " + exact_->type() + " [m/s], [Pa]"};
}


Foam::wordList Foam::functionObjects::ulphError::columns() const
{
    return
    {
        "U_L1", "U_L2", "U_Linf", "U_rms", "p_L1", "p_L2", "p_Linf", "p_rms"
    };
}


Foam::scalarList Foam::functionObjects::ulphError::row()
{
    const ulphCloud& cloud = particles();
    const equationOfState& state = *models().state;

    exact_->setTime(time_.value());
    const scalar level = pressureLevel();
    errorSums U;
    errorSums p;
    for (label i = 0; i < cloud.size(); ++i)
    {
        const point x(cloud.position(i));
        const scalar rho1 = cloud.densityExcess()(i);
        const scalar V = cloud.mass()(i)/(cloud.rho0() + rho1);

        const vector exactU(exact_->U(x));
        U.add(V, mag(cloud.toVector(cloud.v(), i) - exactU), mag(exactU));

        const scalar exactP = exact_->p(x);
        p.add(V, mag(state.pressure(rho1) - level - exactP), exactP);
    }

    scalarList values(U.norms());
    values.append(p.norms());
    return values;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::ulphError::read(const dictionary& dict)
{
    exact_ = exactField::New(dict, particles());
    return ulphFunctionObject::read(dict);
}


// ************************************************************************* //
