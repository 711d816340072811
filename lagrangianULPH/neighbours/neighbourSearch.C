/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neighbourSearch.H"
#include "fvMesh.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <numeric>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

ulph::cellLayout Foam::neighbourSearch::makeCells
(
    const ulphCloud& cloud,
    const scalar size
)
{
    // Five layers of wall, and room for what the guard has yet to stop
    const scalar margin = 8*cloud.dx();

    std::array<double, 3> lower{};
    std::array<double, 3> upper{};
    for (int k = 0; k < cloud.D(); ++k)
    {
        lower[k] = cloud.mesh().bounds().min()[cloud.axis(k)] - margin;
        upper[k] = cloud.mesh().bounds().max()[cloud.axis(k)] + margin;
    }
    return ulph::cellLayout(cloud.D(), lower, upper, size);
}


ulph::clusterList::sourceGroup Foam::neighbourSearch::fluidGroup() const
{
    return {&fluid_, cloud_.view(), 0};
}


ulph::clusterList::sourceGroup Foam::neighbourSearch::haloGroup() const
{
    return {&halo_.clusters(), cloud_.haloView(), cloud_.size()};
}


ulph::clusterList::sourceGroup Foam::neighbourSearch::wallGroup() const
{
    return {&wallParticles_, wall_.view(), firstWall()};
}


Foam::scalar Foam::neighbourSearch::imageWidth() const
{
    const scalar sees = reach(imageWay_ > 0 ? widestSkin() : skin_);

    // Wall particles in reach of an image see what is in reach of them
    return (wall_.any() ? 2 : 1)*sees + 2*imageWay_;
}


void Foam::neighbourSearch::build()
{
    setSkin(nextSkin());
    nUses_ = 1;
    const int width = sums_->width();

    halo_.wrap();
    halo_.distribute();
    cloud_.permute(fluid_.sort(cloud_.view(), width));
    halo_.make(imageWidth(), width);
    wall_.update(wallCells_, reach(widestSkin()) + farthest_);
    wall_.permute(wallParticles_.sort(wall_.view(), width));

    fitClusters();
    fluidList_.build
    (
        fluidGroup(), reach(skin_), {fluidGroup(), haloGroup(), wallGroup()}
    );
    wallList_.build(wallGroup(), reach(skin_), {fluidGroup(), haloGroup(), {}});

    sums_->resize(firstWall() + wall_.size());

    sinceBuild_.reset(cloud_.totalView(), skin_);
    fluidRenewed_.reset(fluid_.size());
    wallRenewed_.reset(wallParticles_.size());
    newLists_.resize(fluid_.size());
    std::iota(newLists_.begin(), newLists_.end(), 0);
    valid_ = true;
    ++nBuilds_;
}


void Foam::neighbourSearch::fitClusters()
{
    fluid_.fit(cloud_.view());
    halo_.fit();
    wallParticles_.fit(wall_.view());
}


bool Foam::neighbourSearch::renew()
{
    // Walls take long to choose anew; without them it is memory that counts
    const scalar many = wall_.any() ? 0.6 : 0.2;

    const ulph::particleView all(cloud_.totalView());
    const listAge* const sinceBuild =
        sinceBuild_.measure(all) ? &sinceBuild_ : nullptr;
    const bool any = fluidRenewed_.any() || wallRenewed_.any();
    const listAge* const sinceRenewal =
        any && sinceRenewal_.measure(all) ? &sinceRenewal_ : nullptr;

    const auto outdated = [&]
    (
        renewedClusters& renewed,
        const ulph::clusterList::sourceGroup& group
    )
    {
        return renewed.outdated
        (
            *group.clusters, group.particles, sinceBuild, sinceRenewal
        );
    };
    const bool fluidOutdated = outdated(fluidRenewed_, fluidGroup());
    const bool wallOutdated = outdated(wallRenewed_, wallGroup());
    if (!fluidOutdated && !wallOutdated)
    {
        return true;
    }

    fluidRenewed_.addDue();
    wallRenewed_.addDue();
    // Images are those of the last build
    if
    (
        (halo_.any() && sinceBuild_.farthest(all) > imageWay_)
     || fluidRenewed_.numbers().size() > many*fluid_.size()
    )
    {
        return false;
    }
    fitClusters();
    fluidList_.renew
    (
        fluidRenewed_.numbers(),
        fluidGroup(),
        reach(widestSkin()),
        {fluidGroup(), haloGroup(), wallGroup()}
    );
    wallList_.renew
    (
        wallRenewed_.numbers(),
        wallGroup(),
        reach(widestSkin()),
        {fluidGroup(), haloGroup(), {}}
    );
    sinceRenewal_.reset(all, widestSkin());
    newLists_ = fluidRenewed_.numbers();
    ++nRenewals_;
    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::neighbourSearch::neighbourSearch
(
    ulphCloud& cloud,
    wallLayer& wall,
    const kernel& weight,
    const scalar skin
)
:
    cloud_(cloud),
    wall_(wall),
    sums_(weight.sums(cloud.shared().mixed)),
    widest_(skin*cloud.dx()),
    skin_(widest_),
    farthest_(2*cloud.dx()),
    stray_(0.5*cloud.dx()),
    imageWay_(Pstream::parRun() ? 0.5*cloud.dx() : 0),
    curve_(std::make_shared<ulph::cellCurve>(makeCells(cloud, 8*cloud.dx()))),
    wallCells_(makeCells(cloud, 2*cloud.dx())),
    halo_(cloud, curve_),
    fluid_(curve_),
    wallParticles_(curve_),
    sinceBuild_(wall, makeCells(cloud, 2*cloud.h())),
    sinceRenewal_(sinceBuild_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::neighbourSearch::nextSkin() const
{
    // A build takes as long as pairs out of reach do in so many uses of lists with a
    // skin of dx
    const scalar perBuild = cloud_.D() == 2 ? 2 : 1;

    return valid_ ? std::sqrt(perBuild*cloud_.dx()*skin_/nUses_) : skin_;
}


bool Foam::neighbourSearch::contains() const
{
    const boundBox& bounds = cloud_.mesh().bounds();
    bool inside = true;
    for (int k = 0; k < cloud_.D(); ++k)
    {
        const double* const x = cloud_.x().component(k);
        double lower = GREAT;
        double upper = -GREAT;

        #pragma omp parallel for schedule(static) \
            reduction(min : lower) reduction(max : upper)
        for (label i = 0; i < cloud_.size(); ++i)
        {
            lower = x[i] < lower ? x[i] : lower;
            upper = x[i] > upper ? x[i] : upper;
        }
        const direction d = cloud_.axis(k);
        const scalar slack = halo_.cyclic().repeats(d) ? stray_ : 0;
        if (lower < bounds.min()[d] - slack || upper > bounds.max()[d] + slack)
        {
            inside = false;
        }
    }
    return returnReduce(inside, andOp<bool>());
}


void Foam::neighbourSearch::wrap()
{
    if (halo_.wrap())
    {
        invalidate();
    }
}


bool Foam::neighbourSearch::update()
{
    newLists_.clear();
    if (valid_)
    {
        halo_.copyPositions();
        const bool strayed = halo_.strayed(stray_);
        const bool hold =
            !strayed
         && sinceBuild_.farthest(cloud_.totalView()) < farthest_
         && renew();
        if (returnReduce(hold, andOp<bool>()))
        {
            ++nUses_;
            return false;
        }
    }
    build();
    return true;
}


std::size_t Foam::neighbourSearch::bytes() const
{
    return sums_->bytes() + fluidList_.bytes() + wallList_.bytes()
      + fluid_.bytes() + halo_.bytes() + wallParticles_.bytes()
      + sinceBuild_.bytes() + sinceRenewal_.bytes() + fluidRenewed_.bytes()
      + wallRenewed_.bytes() + sizeof(int)*newLists_.capacity();
}


// ************************************************************************* //
