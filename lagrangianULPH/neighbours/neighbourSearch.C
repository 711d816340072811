/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neighbourSearch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::shared_ptr<const ulph::cellLayout>
Foam::neighbourSearch::makeCells(const ulphCloud& cloud, const scalar size)
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
    return std::make_shared<ulph::cellLayout>
    (
        cloud.D(), lower, upper, size
    );
}


Foam::scalar Foam::neighbourSearch::nextSkin() const
{
    // A list costs as much as some four steps of pair sums, a wide skin a tenth more
    // of these
    constexpr label few = 2;
    constexpr label many = 8;
    const scalar wide = 2*narrow_;

    if (!valid_ || nUses_ > many)
    {
        return narrow_;
    }
    return nUses_ <= few ? wide : skin_;
}


void Foam::neighbourSearch::build()
{
    skin_ = nextSkin();
    nUses_ = 1;

    const scalar reach = 2*cloud_.h() + skin_;
    const scalar longest = 8*cloud_.dx();

    halo_.clear();
    halo_.wrap();
    cloud_.permute(fluidGrid_.sort(cloud_.view()));
    // Wall particles in reach of an image see what is in reach of them
    halo_.make(wall_.any() ? 2*reach : reach);
    wall_.update(fluidGrid_, reach + farthest_);
    if (wall_.any())
    {
        wall_.permute(wallGrid_.sort(wall_.view()));
    }

    const ulph::clusterList::sourceGroup fluid
    {
        &fluidGrid_, cloud_.view(), 0
    };
    const ulph::clusterList::sourceGroup halo
    {
        &halo_.grid(), cloud_.haloView(), cloud_.size()
    };
    const ulph::clusterList::sourceGroup wall
    {
        &wallGrid_, wall_.view(), firstWall()
    };

    const int width = sums_->width();
    fluidList_.build(fluid, width, reach, longest, {fluid, halo, wall});
    wallList_.build(wall, width, reach, longest, {fluid, halo, {}});

    sums_->resize(firstWall() + wall_.size());

    motion_.reset(cloud_.totalView(), wall_.view());
    valid_ = true;
    ++nBuilds_;
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
    narrow_(skin*cloud.dx()),
    skin_(narrow_),
    farthest_(2*cloud.dx()),
    stray_(0.5*cloud.dx()),
    cells_(makeCells(cloud, 2*cloud.dx())),
    halo_(cloud, cells_),
    fluidGrid_(cells_),
    wallGrid_(cells_),
    motion_(makeCells(cloud, 2*(cloud.h() + narrow_)))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::neighbourSearch::contains() const
{
    const boundBox& bounds = cloud_.mesh().bounds();
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
            return false;
        }
    }
    return true;
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
    halo_.copyPositions();
    const scalar way = wall_.way();
    if
    (
        valid_
     && way < skin_
     && !halo_.strayed(stray_)
     && !motion_.exceeds(cloud_.totalView(), skin_ - way, farthest_ - way)
    )
    {
        ++nUses_;
        return false;
    }
    build();
    return true;
}


std::size_t Foam::neighbourSearch::bytes() const
{
    return sums_->bytes() + fluidList_.bytes() + wallList_.bytes()
      + fluidGrid_.bytes() + wallGrid_.bytes() + motion_.bytes();
}


// ************************************************************************* //
