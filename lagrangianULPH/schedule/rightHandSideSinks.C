/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rightHandSideSinks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// The walls push with their own inverse moment 1/beta beside that of the particle,
// K: so their part of the divergence, K : L, must take the mean of both, or
// impacts of thin fluid, whose K is large, would gain energy
static void meanOfWalls
(
    const int D,
    const ulph::divergenceBlock& sums,
    const scalar beta,
    const ulph::laneRow* K,
    ulph::laneRow& div
)
{
    if (!sums.walls)
    {
        return;
    }
    momentTensor::addContraction(D, sums.count, -0.5, K, sums.wallL, div);
    for (int k = 0; k < D; ++k)
    {
        const ulph::laneRow& diagonal = sums.wallL[k*D + k];
        ulph::forLanes(sums.count, [&](const int l)
        {
            div[l] += 0.5/beta*diagonal[l];
        });
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::storeDivergence
(
    const int D,
    const ulph::divergenceBlock& sums,
    const scalar beta,
    const particleField& inverseMoment,
    particleField& divergence
)
{
    ulph::laneRow K[6];
    inverseMoment.load(sums.first, sums.count, K);
    ulph::laneRow div = {};
    momentTensor::addContraction(D, sums.count, 1, K, sums.L, div);
    meanOfWalls(D, sums, beta, K, div);
    divergence.store(0, sums.first, sums.count, div);
}


// * * * * * * * * * * * * * * * geometrySink  * * * * * * * * * * * * * * * //

Foam::geometrySink::geometrySink
(
    ulphCloud& cloud,
    ulphModels& models,
    const linearMap& force,
    const bool surfaceKnown,
    const scalar ahead,
    const tensor& tankGradient
)
:
    cloud_(cloud),
    D_(cloud.D()),
    models_(models),
    force_(force),
    surfaceKnown_(surfaceKnown),
    ahead_(ahead),
    K_(*cloud.derived("inverseMoment")),
    b_(*cloud.derived("kernelGradient")),
    divergence_(*cloud.derived("divergence")),
    afterKick_(cloud.saved("divergenceAfterKick")),
    surface_(cloud.derived("surface")),
    lambda_(cloud.derived("lambda")),
    gradient_(cloud.derived("densityGradient")),
    diffusion_(cloud.derived("densityDiffusion")),
    relaxation_(cloud.derived("densityRelaxation")),
    shift_(cloud.derived("shift"))
{
    for (int k = 0; k < D_; ++k)
    {
        for (int m = 0; m < D_; ++m)
        {
            tankGradient_[k*D_ + m] = tankGradient(cloud.axis(k), cloud.axis(m));
        }
    }
}


void Foam::geometrySink::hydrostaticGradient
(
    const label first,
    const label n,
    ulph::laneRow* gradient
) const
{
    const scalar scale = cloud_.rho0()/sqr(cloud_.c0());
    force_.rows(cloud_, cloud_.x(), nullptr, first, n, gradient);
    for (int k = 0; k < D_; ++k)
    {
        ulph::forLanes(n, [&](const int l) { gradient[k][l] *= scale; });
    }
}


void Foam::geometrySink::takeDivergence
(
    const ulph::geometryBlock& sums,
    const ulph::laneRow* K
)
{
    // Where the pass after the kick gave none, it is that of this pass
    ulph::laneRow afterKick;
    ulph::laneRow ahead;
    std::fill_n(afterKick, sums.count, divergenceSink::notTaken);
    if (afterKick_)
    {
        afterKick_->load(0, sums.first, sums.count, afterKick);
    }
    ulph::forLanes(sums.count, [&](const int l)
    {
        ahead[l] = afterKick[l] == divergenceSink::notTaken ? ahead_ : 0;
    });

    ulph::laneRow div;
    momentTensor::divergence
    (
        D_, sums.count, K, sums.L, ahead, tankGradient_, div
    );
    meanOfWalls(D_, sums, cloud_.shared().beta, K, div);
    divergence_.store(0, sums.first, sums.count, div);

    if (afterKick_)
    {
        for (label l = 0; l < sums.count; ++l)
        {
            if (afterKick[l] == divergenceSink::notTaken)
            {
                afterKick[l] = div[l];
            }
        }
        afterKick_->store(0, sums.first, sums.count, afterKick);
    }
}


void Foam::geometrySink::take(const ulph::geometryBlock& sums)
{
    ulph::laneRow K[6];
    ulph::laneRow surface = {};
    if (surfaceKnown_)
    {
        surface_->load(0, sums.first, sums.count, surface);
    }
    models_.moment->invert(sums, surface, K);
    K_.store(sums.first, sums.count, K);
    b_.store(sums.first, sums.count, sums.b);

    takeDivergence(sums, K);

    if (lambda_ && !surfaceKnown_)
    {
        ulph::laneRow lambda;
        models_.surface->eigenvalue(sums, lambda);
        lambda_->store(0, sums.first, sums.count, lambda);
    }

    if (diffusion_)
    {
        ulph::laneRow rate = {};
        if (gradient_)
        {
            ulph::laneRow gradient[3];
            momentTensor::multiply(D_, sums.count, K, sums.G, gradient);
            gradient_->store(sums.first, sums.count, gradient);
            models_.diffusion->addGradientRate(sums, K, gradient, rate);
        }
        else if (models_.diffusion->hydrostatic())
        {
            ulph::laneRow gradient[3];
            hydrostaticGradient(sums.first, sums.count, gradient);
            models_.diffusion->addGradientRate(sums, K, gradient, rate);
        }
        models_.diffusion->addLaplacianRate(sums, K, rate);
        diffusion_->store(0, sums.first, sums.count, rate);
    }

    if (relaxation_)
    {
        ulph::laneRow rate;
        models_.relaxation->rate(sums, rate);
        relaxation_->store(0, sums.first, sums.count, rate);
    }

    if (shift_)
    {
        ulph::laneRow R[3];
        models_.shift->direction(sums, R);
        shift_->store(sums.first, sums.count, R);
    }
}


// * * * * * * * * * * * * * *  divergenceSink  * * * * * * * * * * * * * * * //

Foam::divergenceSink::divergenceSink(ulphCloud& cloud)
:
    D_(cloud.D()),
    beta_(cloud.shared().beta),
    K_(*cloud.derived("inverseMoment")),
    afterKick_(*cloud.saved("divergenceAfterKick"))
{}


void Foam::divergenceSink::take(const ulph::geometryBlock& sums)
{
    storeDivergence(D_, sums, beta_, K_, afterKick_);
}


// * * * * * * * * * * * * * *  eigenvalueSink  * * * * * * * * * * * * * * * //

Foam::eigenvalueSink::eigenvalueSink
(
    ulphCloud& cloud,
    const freeSurface& surface
)
:
    surface_(surface),
    lambda_(*cloud.derived("lambda"))
{}


void Foam::eigenvalueSink::take(const ulph::geometryBlock& sums)
{
    ulph::laneRow lambda;
    surface_.eigenvalue(sums, lambda);
    lambda_.store(0, sums.first, sums.count, lambda);
}


// ************************************************************************* //
