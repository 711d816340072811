/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphProbes.H"
#include "addToRunTimeSelectionTable.H"

#include <Eigen/Eigenvalues>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(ulphProbes, 0);
    addToRunTimeSelectionTable(functionObject, ulphProbes, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::functionObjects::ulphProbes::valuesAt(const point& where) const
{
    // Below this part of the largest eigenvalue of A it is not inverted
    constexpr scalar determined = 1e-3;

    const ulphCloud& cloud = particles();
    const equationOfState& state = *models().state;
    const int D = cloud.D();

    Eigen::Matrix4d A(Eigen::Matrix4d::Zero());
    Eigen::Matrix4d sums(Eigen::Matrix4d::Zero());
    forParticles(where, [&](const label i, const vector& d)
    {
        const scalar r = mag(d);
        if (r >= reach())
        {
            return;
        }
        Eigen::Vector4d b(Eigen::Vector4d::Zero());
        for (int k = 0; k < D; ++k)
        {
            b[k + 1] = d[cloud.axis(k)];
        }
        b /= cloud.h();
        b[0] = 1;

        const scalar rho1 = cloud.densityExcess()(i);
        const scalar wV =
            weight(r)*cloud.mass()(i)/(cloud.rho0() + rho1);
        const vector v(cloud.toVector(cloud.v(), i));
        const Eigen::RowVector4d f(state.pressure(rho1), v.x(), v.y(), v.z());
        A += wV*b*b.transpose();
        sums += wV*b*f;
    });
    for (Eigen::Matrix4d* const matrix : {&A, &sums})
    {
        for (label c = 0; c < label(matrix->size()); ++c)
        {
            reduce(matrix->data()[c], sumOp<scalar>());
        }
    }

    scalarList values(5, Zero);
    values[0] = A(0, 0);
    if (values[0] > VSMALL)
    {
        Eigen::RowVector4d f(sums.row(0)/A(0, 0));

        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver
        (
            A.topLeftCorner(D + 1, D + 1)
        );
        const Eigen::VectorXd& lambda = solver.eigenvalues();
        if (moving_ && lambda[0] > determined*lambda[D])
        {
            const Eigen::MatrixXd& Q = solver.eigenvectors();
            const Eigen::VectorXd first
            (
                Q*lambda.cwiseInverse().asDiagonal()*Q.row(0).transpose()
            );
            f = first.transpose()*sums.topRows(D + 1);
        }
        for (label c = 0; c < 4; ++c)
        {
            values[c + 1] = f[c];
        }
    }
    return values;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::ulphProbes::ulphProbes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    ulphPointSamples(name, runTime, dict, typeName)
{
    read(dict);
    start();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::ulphProbes::read(const dictionary& dict)
{
    readPoints(dict, "points");
    moving_ = dict.getOrDefault("moving", true);

    return ulphFunctionObject::read(dict);
}


// ************************************************************************* //
