/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphProbes.H"
#include "addToRunTimeSelectionTable.H"
#include "cylindricalCS.H"
#include "inputChecks.H"
#include "wallLayer.H"
#include "fvMesh.H"

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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::ulphProbes::makeFace(const vector& n)
{
    const ulphCloud& cloud = particles();
    const scalar radius = 0.5*diameter_;

    // Squares, or strips, of at most dx/2
    const label half = label(std::ceil(radius/(0.5*cloud.dx())));
    const scalar step = radius/half;
    DynamicList<vector> offsets;
    DynamicList<scalar> shares;
    if (cloud.D() == 2)
    {
        const label empty = 3 - cloud.axis(0) - cloud.axis(1);
        vector across(Zero);
        across[empty] = 1;
        for (label i = -half; i < half; ++i)
        {
            const scalar a = (i + 0.5)*step;
            offsets.append(a*(n ^ across));
            // The chord of the disc
            shares.append(std::sqrt(sqr(radius) - sqr(a)));
        }
    }
    else
    {
        const coordSystem::cylindrical axes(Zero, n);
        for (label i = -half; i < half; ++i)
        {
            for (label j = -half; j < half; ++j)
            {
                const scalar a = (i + 0.5)*step;
                const scalar b = (j + 0.5)*step;
                if (sqr(a) + sqr(b) < sqr(radius))
                {
                    offsets.append(a*axes.e1() + b*axes.e2());
                    shares.append(1);
                }
            }
        }
    }
    faceOffsets_ = offsets;
    faceShares_ = scalarField(shares)/Foam::sum(scalarField(shares));
}


Foam::scalar Foam::functionObjects::ulphProbes::wallPressure
(
    const point& where,
    const scalar mean,
    const vector& offset
) const
{
    const scalar t = time_.value();
    const vector f(motion_.atRest(models().force->at(t), t)(where));
    const scalar balance = -particles().rho0()*(f & offset);
    return wallLayer::isSeparated(mean, balance) ? mean : mean + balance;
}


Foam::scalarList Foam::functionObjects::ulphProbes::fit
(
    const point& where,
    const neighbours& near,
    const vector& offset
) const
{
    // Below this part of the largest eigenvalue of A it is not inverted
    constexpr scalar determined = 1e-3;

    const ulphCloud& cloud = particles();
    const equationOfState& state = *models().state;
    const int D = cloud.D();

    Eigen::Matrix4d A(Eigen::Matrix4d::Zero());
    Eigen::Matrix4d sums(Eigen::Matrix4d::Zero());
    for (const auto& neighbour : near)
    {
        const label i = neighbour.first();
        const vector d(neighbour.second() - offset);
        const scalar r = mag(d);
        if (r >= reach())
        {
            continue;
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
    }
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
        if (inWall_)
        {
            vector mean(Zero);
            for (int k = 0; k < D; ++k)
            {
                mean[cloud.axis(k)] = cloud.h()*A(0, k + 1)/A(0, 0);
            }
            values[1] = wallPressure(where + offset, sums(0, 0)/A(0, 0), mean);
        }
    }
    return values;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::functionObjects::ulphProbes::valuesAt(const point& where) const
{
    neighbours near;
    const scalar farthest = reach() + 0.5*diameter_;
    forParticles(where, [&](const label i, const vector& d)
    {
        if (magSqr(d) < sqr(farthest))
        {
            near.append(neighbours::value_type(i, d));
        }
    });

    // On a wall half of the kernel sees fluid, at the fluid's edge a quarter
    constexpr scalar wet = 0.25;

    scalarList mean(5, Zero);
    forAll(faceOffsets_, s)
    {
        scalarList values(fit(where, near, faceOffsets_[s]));
        if (inWall_ && values[0] < wet)
        {
            // A part of it is covered, and what is dry does not pull
            values[1] = max(values[1], scalar(0));
            const scalar filling = values[0];
            for (label c = 1; c < values.size(); ++c)
            {
                values[c] *= filling/wet;
            }
        }
        forAll(mean, c)
        {
            mean[c] += faceShares_[s]*values[c];
        }
    }
    return mean;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::ulphProbes::ulphProbes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    ulphPointSamples(name, runTime, dict, typeName),
    motion_(models().dict, mesh_)
{
    read(dict);
    start();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::ulphProbes::read(const dictionary& dict)
{
    readPoints(dict, "points");
    moving_ = dict.getOrDefault("moving", true);

    // A point is a face of one place
    faceOffsets_ = vectorField(1, vector(Zero));
    faceShares_ = scalarField(1, 1.0);
    diameter_ =
        dict.found("diameter")
      ? getInRange(dict, "diameter", scalarMinMax::ge(SMALL))
      : 0;
    inWall_ = dict.found("normal") || diameter_ > 0;
    if (inWall_)
    {
        const vector normal
        (
            unitDirection(dict, "normal", dict.get<vector>("normal"))
        );
        if (diameter_ > 0)
        {
            makeFace(normal);
        }
    }

    return ulphFunctionObject::read(dict);
}


// ************************************************************************* //
