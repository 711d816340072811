/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rightHandSideSinks.H"

// * * * * * * * * * * * * * * accelerationSink  * * * * * * * * * * * * * * //

Foam::accelerationSink::accelerationSink
(
    ulphCloud& cloud,
    const ulphModels& models,
    const linearMap& force
)
:
    models_(models),
    force_(force),
    acceleration_(*cloud.derived("acceleration")),
    viscous_(cloud.derived("viscousAcceleration")),
    cloud_(cloud),
    K_(*cloud.derived("inverseMoment")),
    b_(*cloud.derived("kernelGradient"))
{}


void Foam::accelerationSink::addBodyForce
(
    const label first,
    const label n,
    ulph::laneRow* a
) const
{
    ulph::laneRow f[3];
    force_.rows(cloud_, cloud_.x(), &cloud_.v(), first, n, f);
    for (int k = 0; k < cloud_.D(); ++k)
    {
        ulph::forLanes(n, [&](const int l) { a[k][l] += f[k][l]; });
    }
}


void Foam::accelerationSink::takeAcceleration(const ulph::forceBlock& sums)
{
    const int D = cloud_.D();
    const label n = sums.count;

    ulph::laneRow K[6];
    ulph::laneRow b[3];
    ulph::laneRow Kb[3];
    ulph::laneRow rho1;
    ulph::laneRow p;
    ulph::laneRow a[3];

    K_.load(sums.first, n, K);
    b_.load(sums.first, n, b);
    momentTensor::multiply(D, n, K, b, Kb);
    cloud_.densityExcess().load(0, sums.first, n, rho1);
    models_.state->pressure(n, rho1, p);

    for (int k = 0; k < D; ++k)
    {
        ulph::forLanes(n, [&](const int l)
        {
            a[k][l] = -(sums.pressure[k][l] + p[l]*Kb[k][l]);
        });
    }

    const scalar mu = models_.viscous->mu();
    if (mu > 0)
    {
        ulph::laneRow KA[3];
        momentTensor::multiply(D, n, K, sums.A, KA);
        const bool symmetric = models_.viscous->symmetric();
        for (int k = 0; k < D; ++k)
        {
            ulph::forLanes(n, [&](const int l)
            {
                KA[k][l] =
                    symmetric
                  ? 0.5*mu*(KA[k][l] + sums.symmetricA[k][l])
                  : mu*KA[k][l];
                a[k][l] += KA[k][l];
            });
        }
        if (viscous_)
        {
            for (int k = 0; k < D; ++k)
            {
                for (label l = 0; l < n; ++l)
                {
                    KA[k][l] /= cloud_.rho0() + rho1[l];
                }
            }
            viscous_->store(sums.first, n, KA);
        }
    }

    for (int k = 0; k < D; ++k)
    {
        ulph::forLanes(n, [&](const int l)
        {
            a[k][l] /= cloud_.rho0() + rho1[l];
        });
    }
    if (!force_.zero())
    {
        addBodyForce(sums.first, n, a);
    }
    acceleration_.store(sums.first, n, a);
}


// * * * * * * * * * * * * * * * * forceSink * * * * * * * * * * * * * * * * //

Foam::forceSink::forceSink
(
    ulphCloud& cloud,
    const ulphModels& models,
    const linearMap& force
)
:
    accelerationSink(cloud, models, force),
    model_(*models.diffusion),
    diffusion_(cloud.saved("neighbourDiffusion"))
{}


void Foam::forceSink::take(const ulph::forceBlock& sums)
{
    takeAcceleration(sums);
    if (diffusion_)
    {
        ulph::laneRow K[6];
        ulph::laneRow rate = {};
        K_.load(sums.first, sums.count, K);
        model_.addForceRate(sums, K, rate);
        diffusion_->store(0, sums.first, sums.count, rate);
    }
}


// * * * * * * * * * * * * * *  frozenForceSink * * * * * * * * * * * * * * * //

Foam::frozenForceSink::frozenForceSink
(
    ulphCloud& cloud,
    const ulphModels& models,
    const linearMap& force
)
:
    accelerationSink(cloud, models, force),
    divergence_(*cloud.derived("divergence"))
{}


void Foam::frozenForceSink::take(const ulph::forceBlock& sums)
{
    b_.store(sums.first, sums.count, sums.b);
    storeDivergence(cloud_.D(), sums, cloud_.shared().beta, K_, divergence_);
    takeAcceleration(sums);
}


// ************************************************************************* //
