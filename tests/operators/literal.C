/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "literal.H"
#include "literalNeighbours.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::literal::literal(const rig& library, const coefficients& c)
:
    rig_(library),
    c_(c),
    D_(library.cloud.D()),
    dx_(library.cloud.dx()),
    h_(library.cloud.h()),
    rho0_(library.cloud.rho0()),
    c0_(library.cloud.c0()),
    kernel_(library.dict().getOrDefault<word>("kernel", "WendlandC2"))
{
    const ulphCloud& cloud = library.cloud;
    for (int i = 0; i < cloud.size(); ++i)
    {
        particle I;
        I.x = rig_.solved(cloud.position(i));
        I.v = I.viscousV = rig_.solved(cloud.toVector(cloud.v(), i));
        I.rho = rho0_ + cloud.densityExcess()(i);
        I.V = cloud.mass()(i)/I.rho;
        I.p = pressure(I.rho);
        fluid.push_back(I);
    }
    setWalls();

    for (int i = 0; i < cloud.size(); ++i)
    {
        moment
        (
            fluid[i], rig_.has("surface") ? rig_.scalarOf("surface", i) : 0
        );
    }
    for (particle& I : fluid)
    {
        gradients(I);
    }
    const auto bodyForce = [&](const particle& I)
    {
        return rig_.solved
        (
            library.models.force->at(0)(rig_.unsolved(I.x))
        );
    };
    if (c_.hydrostatic)
    {
        for (particle& I : fluid)
        {
            I.gradRho = rho0_/sqr(c0_)*bodyForce(I);
        }
    }
    for (particle& I : fluid)
    {
        rates(I);
        I.dvdt += bodyForce(I);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double Foam::literal::pressure(const double rho) const
{
    const double gamma = c_.gamma;
    return rho0_*sqr(c0_)/gamma*std::expm1(gamma*std::log1p(rho/rho0_ - 1));
}


double Foam::literal::density(const double p) const
{
    const double gamma = c_.gamma;
    return rho0_*std::pow(1 + p*gamma/(rho0_*sqr(c0_)), 1/gamma);
}


void Foam::literal::moment(particle& I, const double surfaceClass) const
{
    const auto add = [&](const particle& J, const vec& x, double, double w)
    {
        I.M += w*J.V*x*x.transpose();
    };
    forNeighbours(I, fluid, add);
    forNeighbours(I, walls, add);

    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen
    (
        I.M.topLeftCorner(D_, D_)
    );
    I.lambda = eigen.eigenvalues()[0]/sqr(dx_);

    auto K = I.K.topLeftCorner(D_, D_);
    switch (c_.K)
    {
        case inverse::full:
        {
            K = I.M.topLeftCorner(D_, D_).inverse();
            break;
        }
        case inverse::floored:
        {
            const double floor = 0.36*rig_.cloud.shared().beta;
            K = eigen.eigenvectors()
               *eigen.eigenvalues().cwiseMax(floor).cwiseInverse().asDiagonal()
               *eigen.eigenvectors().transpose();
            break;
        }
        case inverse::optimal:
        {
            // Eq. (39): the diagonal alone for the surface and its vicinity
            K = I.M.topLeftCorner(D_, D_).inverse();
            if (surfaceClass > 0)
            {
                K = I.M.diagonal().head(D_).cwiseInverse().asDiagonal();
            }
        }
    }
}


void Foam::literal::gradients(particle& I) const
{
    const auto add = [&](const particle& J, const vec& x, double, double w)
    {
        I.gradRho += I.K*(w*(J.rho - I.rho)*J.V*x);
    };
    forNeighbours(I, fluid, add);
    forNeighbours(I, walls, add);

    // Eq. (36) over fluid alone, wall particles having no lambda
    mat M(mat::Zero());
    vec G(vec::Zero());
    forNeighbours
    (
        I, fluid, [&](const particle& J, const vec& x, double, double w)
        {
            M += w*J.V*x*x.transpose();
            G += w*J.V*(J.lambda - I.lambda)*x;
        }
    );
    I.normal.head(D_) = -(M.topLeftCorner(D_, D_).inverse()*G.head(D_));
    I.normal.normalize();
}


void Foam::literal::rates(particle& I) const
{
    const double eta2 = sqr(rig_.models.viscous->eta()*h_);
    const double diffusivity = c_.delta*h_*c0_;
    // Eqs (10) and (12)
    const double mu = rho0_*(c_.alpha*h_*c0_ + 2*(D_ + 2)*c_.nu);

    int n = 0;
    double sumR = 0;
    vec directions(vec::Zero());

    const auto add = [&](const particle& J, const vec& x, double r, double w)
    {
        const double wV = w*J.V;
        const vec KIx(I.K*x);
        const vec KJx(J.K*x);

        I.seesWalls = I.seesWalls || J.isWall;

        // Walls with the mean of both inverse moments, which their push has
        I.div += wV*(J.v - I.v).dot(J.isWall ? vec(0.5*(KIx + KJx)) : KIx);

        // Eq. (24) with the plus sign
        I.Phi += diffusivity*wV
           *(
                2*(J.rho - I.rho)*x.dot(KIx)/(r*r)
              - (c_.laplacian ? 0 : (I.gradRho + J.gradRho).dot(KIx))
            );

        I.b += wV*x;
        I.pressureForce -= wV*(J.p*KJx + I.p*KIx);
        I.viscousForce +=
            mu*wV*(J.viscousV - I.v).dot(x)/(r*r + eta2)
           *(c_.symmetric ? vec(0.5*(KIx + KJx)) : KIx);

        ++n;
        sumR += r;
        directions += x/(r*r*r);
    };
    forNeighbours(I, fluid, add);
    forNeighbours(I, walls, add);

    I.dvdt = (I.pressureForce + I.viscousForce)/I.rho;
    I.R = sqr(sumR/n)*directions;
    I.relaxation =
        c_.relaxation*c0_*rho0_/h_
       *(I.M.trace()/(D_*rig_.cloud.shared().beta) - 1);
}


// ************************************************************************* //
