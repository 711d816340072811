/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphMoments.H"
#include "addToRunTimeSelectionTable.H"
#include "momentTensor.H"

#include <Eigen/Eigenvalues>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(ulphMoments, 0);
    addToRunTimeSelectionTable(functionObject, ulphMoments, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Semi-axes [m] of an ellipsoid of D dimensions from its variances [m^2]
static vector semiAxes(const vector& variances, const int D)
{
    vector axes;
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        axes[cmpt] = std::sqrt((D + 2)*max(variances[cmpt], scalar(0)));
    }
    return axes;
}


//- Eigenvalues, falling
static vector eigenvaluesOf(const symmTensor& T)
{
    Eigen::Matrix3d matrix;
    matrix <<
        T.xx(), T.xy(), T.xz(),
        T.xy(), T.yy(), T.yz(),
        T.xz(), T.yz(), T.zz();
    const Eigen::Vector3d values
    (
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>
        (
            matrix, Eigen::EigenvaluesOnly
        ).eigenvalues()
    );
    return vector(values[2], values[1], values[0]);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::ulphMoments::ulphMoments
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

Foam::List<Foam::string> Foam::functionObjects::ulphMoments::remarks() const
{
    return
    {
        "Moments of the particles [kg m s]",
        "angular momentum and extents about "
      + Foam::name(origin_.x()) + ' '
      + Foam::name(origin_.y()) + ' '
      + Foam::name(origin_.z())
    };
}


Foam::wordList Foam::functionObjects::ulphMoments::columns() const
{
    wordList names({"nParticles", "mass", "volume"});
    for
    (
        const char* const vectorName :
        {"centroid", "momentum", "angularMomentum", "axis", "extent"}
    )
    {
        for (const char* const cmpt : {"x", "y", "z"})
        {
            names.append(word(vectorName) + '_' + cmpt);
        }
    }
    for (const char* const number : {"1", "2", "3"})
    {
        names.append(word("principalAxis_") + number);
    }
    return names;
}


Foam::scalarList Foam::functionObjects::ulphMoments::row()
{
    const ulphCloud& cloud = particles();

    scalar mass = 0;
    scalar volume = 0;
    vector first(Zero);
    vector momentum(Zero);
    vector angular(Zero);
    symmTensor second(Zero);
    vector extent(Zero);

    for (label i = 0; i < cloud.size(); ++i)
    {
        const scalar m = cloud.mass()(i);
        const vector x(cloud.position(i) - origin_);
        const vector v(cloud.toVector(cloud.v(), i));

        mass += m;
        volume += m/(cloud.rho0() + cloud.densityExcess()(i));
        first += m*x;
        momentum += m*v;
        angular += m*(x ^ v);
        second += m*sqr(x);
        extent = max(extent, cmptMag(x));
    }
    reduce(mass, sumOp<scalar>());
    reduce(volume, sumOp<scalar>());
    reduce(first, sumOp<vector>());
    reduce(momentum, sumOp<vector>());
    reduce(angular, sumOp<vector>());
    reduce(second, sumOp<symmTensor>());
    reduce(extent, maxOp<vector>());

    const scalar total = max(mass, VSMALL);
    const vector centre(first/total);
    const symmTensor variance(second/total - sqr(centre));
    const vector diagonal(variance.xx(), variance.yy(), variance.zz());

    scalarList values
    ({
        scalar(returnReduce(cloud.size(), sumOp<label>())), mass, volume
    });
    for
    (
        const vector& value :
        {
            vector(centre + origin_),
            momentum,
            angular,
            semiAxes(diagonal, cloud.D()),
            extent,
            semiAxes(eigenvaluesOf(variance), cloud.D())
        }
    )
    {
        for (const scalar cmpt : {value.x(), value.y(), value.z()})
        {
            values.append(cmpt);
        }
    }
    return values;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::ulphMoments::read(const dictionary& dict)
{
    origin_ = dict.getOrDefault<point>("origin", Zero);
    return ulphFunctionObject::read(dict);
}


// ************************************************************************* //
