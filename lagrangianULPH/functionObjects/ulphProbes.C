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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::FixedList<Foam::scalar, 5>
Foam::functionObjects::ulphProbes::valuesAt(const point& where) const
{
    // Below this part of the largest eigenvalue of A it is not inverted
    constexpr scalar determined = 1e-3;

    const ulphCloud& cloud = particles();
    const equationOfState& state = *models().state;
    const int D = cloud.D();

    Eigen::Matrix4d A(Eigen::Matrix4d::Zero());
    Eigen::Matrix4d sums(Eigen::Matrix4d::Zero());
    const auto add = [&](const label i, const point& place)
    {
        Eigen::Vector4d b(Eigen::Vector4d::Zero());
        for (int k = 0; k < D; ++k)
        {
            b[k + 1] = cloud.x()(i, k) - place[cloud.axis(k)];
        }
        const scalar r = b.norm();
        if (r >= reach_)
        {
            return;
        }
        b /= cloud.h();
        b[0] = 1;

        const scalar rho1 = cloud.densityExcess()(i);
        const scalar wV =
            weights_->weight(r)*cloud.mass()(i)/(cloud.rho0() + rho1);
        const vector v(cloud.toVector(cloud.v(), i));
        const Eigen::RowVector4d f(state.pressure(rho1), v.x(), v.y(), v.z());
        A += wV*b*b.transpose();
        sums += wV*b*f;
    };
    for (label i = 0; i < cloud.size(); ++i)
    {
        add(i, where);
        for (const vector& translation : cyclic_.translations())
        {
            add(i, where - translation);
        }
    }
    for (Eigen::Matrix4d* const matrix : {&A, &sums})
    {
        for (label c = 0; c < label(matrix->size()); ++c)
        {
            reduce(matrix->data()[c], sumOp<scalar>());
        }
    }

    FixedList<scalar, 5> values(Zero);
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
    ulphFunctionObject(name, runTime, dict, typeName),
    cyclic_(mesh_)
{
    read(dict);
    start();
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::List<Foam::string> Foam::functionObjects::ulphProbes::remarks() const
{
    List<string> lines(1, "Values at points [Pa], [m/s]");
    forAll(points_, i)
    {
        OStringStream os;
        os << "Probe " << i << ' ' << points_[i];
        lines.append(os.str());
    }
    return lines;
}


Foam::wordList Foam::functionObjects::ulphProbes::columns() const
{
    wordList names;
    forAll(points_, i)
    {
        for (const char* const quantity : {"filling", "p", "Ux", "Uy", "Uz"})
        {
            names.append(word(quantity) + '_' + Foam::name(i));
        }
    }
    return names;
}


Foam::scalarList Foam::functionObjects::ulphProbes::row()
{
    scalarList values;
    for (const point& where : points_)
    {
        for (const scalar value : valuesAt(where))
        {
            values.append(value);
        }
    }
    return values;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::ulphProbes::read(const dictionary& dict)
{
    dict.readEntry("points", points_);
    moving_ = dict.getOrDefault("moving", true);

    const ulphCloud& cloud = particles();
    const kernel weight(models().dict, cloud.D(), cloud.dx());
    weights_ = weight.sums(false);
    reach_ = 2*weight.h();

    return ulphFunctionObject::read(dict);
}


// ************************************************************************* //
