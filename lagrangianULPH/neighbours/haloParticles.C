/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "haloParticles.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::haloParticles::haloParticles
(
    ulphCloud& cloud,
    std::shared_ptr<const ulph::cellCurve> curve
)
:
    cloud_(cloud),
    cyclic_(cloud.mesh()),
    clusters_(std::move(curve))
{
    cyclic_.warnOfMisfit(cloud.dx());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::haloParticles::strayed(const scalar farthest) const
{
    if (!cyclic_.any())
    {
        return false;
    }
    bool any = false;

    #pragma omp parallel for schedule(static) reduction(|| : any)
    for (label i = 0; i < cloud_.size(); ++i)
    {
        any = any || cyclic_.past(cloud_.position(i)) > farthest;
    }
    return any;
}


bool Foam::haloParticles::wrap()
{
    if (!cyclic_.any())
    {
        return false;
    }
    bool any = false;

    #pragma omp parallel for schedule(static) reduction(|| : any)
    for (label i = 0; i < cloud_.size(); ++i)
    {
        const point p(cloud_.position(i));
        if (cyclic_.past(p) > 0)
        {
            cloud_.translate(i, cyclic_.wrapped(p) - p);
            any = true;
        }
    }
    return any;
}


void Foam::haloParticles::clear()
{
    images_.clear();
    cloud_.setHalo(0);
}


void Foam::haloParticles::make(const scalar width, const int clusterWidth)
{
    if (!cyclic_.any())
    {
        return;
    }
    cyclic_.checkPeriods(width);

    const int D = cloud_.D();
    const boundBox& mesh = cloud_.mesh().bounds();
    const auto isNear = [&](const point& p)
    {
        bool inside = true;
        for (int k = 0; k < D; ++k)
        {
            const direction d = cloud_.axis(k);
            inside =
                inside
             && p[d] > mesh.min()[d] - width
             && p[d] < mesh.max()[d] + width;
        }
        return inside;
    };

    std::vector<image> found;
    std::array<std::vector<double>, 3> x;
    for (label i = 0; i < cloud_.size(); ++i)
    {
        const point p(cloud_.position(i));
        for (std::size_t t = 0; t < cyclic_.translations().size(); ++t)
        {
            const point there(p + cyclic_.translations()[t]);
            if (isNear(there))
            {
                found.push_back({i, label(t)});
                for (int k = 0; k < D; ++k)
                {
                    x[k].push_back(there[cloud_.axis(k)]);
                }
            }
        }
    }

    ulph::particleView view;
    view.D = D;
    view.n = int(found.size());
    for (int k = 0; k < D; ++k)
    {
        view.x[k] = x[k].data();
    }
    images_.clear();
    for (const int i : clusters_.sort(view, clusterWidth))
    {
        images_.push_back(found[i]);
    }
    cloud_.setHalo(view.n);
    copyPositions();
    copy(cloud_.mass());
}


void Foam::haloParticles::copyPositions()
{
    if (images_.empty())
    {
        return;
    }
    const label n = label(images_.size());
    for (int k = 0; k < cloud_.D(); ++k)
    {
        double* const x = cloud_.x().component(k);
        const direction d = cloud_.axis(k);

        #pragma omp parallel for schedule(static)
        for (label i = 0; i < n; ++i)
        {
            const image& from = images_[i];
            x[cloud_.size() + i] =
                x[from.source] + cyclic_.translations()[from.translation][d];
        }
    }
}


void Foam::haloParticles::copy(particleField& field) const
{
    if (images_.empty())
    {
        return;
    }
    const label n = label(images_.size());
    for (int c = 0; c < field.nComponents(); ++c)
    {
        #pragma omp parallel for schedule(static)
        for (label i = 0; i < n; ++i)
        {
            field.set(cloud_.size() + i, c, field(images_[i].source, c));
        }
    }
}


// ************************************************************************* //
