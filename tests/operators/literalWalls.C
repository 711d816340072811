/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "literalNeighbours.H"

#include "wallParticles.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::literal::setWalls()
{
    if (!rig_.search().hasWalls())
    {
        return;
    }

    // All of them: the library is to find those in reach by itself
    wallParticles all(rig_.search(), dx_);
    all.update([](const boundBox&) { return true; });
    const wallParticleSet& set = all.active();

    for (label i = 0; i < set.size(); ++i)
    {
        particle W;
        W.x = rig_.solved(set.position[i]);
        W.V = set.volume[i];
        W.p = 0;
        W.isWall = true;
        W.K.topLeftCorner(D_, D_).diagonal().setConstant
        (
            1/rig_.cloud.shared().beta
        );

        const vec f
        (
            rig_.solved
            (
                rig_.models.force->at(0)(set.position[i])
            )
        );

        double sumW = 0;
        double rho1 = 0;
        double balance = 0;
        vec v(vec::Zero());
        vec apart(vec::Zero());
        forNeighbours
        (
            W, fluid, [&](const particle& F, const vec& x, double, double w)
            {
                // x points from the wall particle to the fluid
                sumW += w;
                v += w*F.v;
                apart += w*x;
                rho1 += w*(F.rho - rho0_);
                balance -= w*F.rho*f.dot(x);
            }
        );
        if (sumW > 0)
        {
            v /= sumW;
            apart /= sumW;

            // A wall does not hold fluid without pressure
            W.p = pressure(rho0_ + rho1/sumW);
            W.p += W.p <= 0 && balance < 0 ? 0 : balance/sumW;
        }

        mat reflection(mat::Zero());
        for (int k = 0; k < D_; ++k)
        {
            for (int l = 0; l < D_; ++l)
            {
                reflection(k, l) = tensor(set.reflection[i])
                (
                    rig_.cloud.axis(k), rig_.cloud.axis(l)
                );
            }
        }
        // Linear in the distance from the wall
        const mat N(0.5*(mat::Identity() - reflection));
        const vec behind(N*rig_.solved(set.distance[i]*set.normal[i]));
        const double height = (N*apart).norm() - behind.norm();
        W.v = v - (1 + behind.norm()/std::max(height, 0.5*dx_))*(N*v);
        W.viscousV = c_.noSlip ? vec(-v) : W.v;
        W.rho = density(W.p);
        W.gradRho = rho0_/sqr(c0_)*f;
        walls.push_back(W);
    }
}


// ************************************************************************* //
