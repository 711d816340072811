/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pairRig.H"

#include <numeric>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pairRig::pairRig
(
    const particleSample& particles,
    const int width,
    const double reach,
    const double cellSize
)
:
    sample(particles)
{
    std::array<double, 3> lower{};
    std::array<double, 3> upper{};
    for (int k = 0; k < sample.D; ++k)
    {
        lower[k] = GREAT;
        upper[k] = -GREAT;
        for (const vec& x : sample.x)
        {
            lower[k] = std::min(lower[k], x[k]);
            upper[k] = std::max(upper[k], x[k]);
        }

        // A few particles lie beyond the cells, as those do that flee the mesh
        const double margin = 0.02*(upper[k] - lower[k]);
        lower[k] += margin;
        upper[k] -= margin;
        longest = std::max(longest, cellSize + 2*margin);
    }
    const auto curve = std::make_shared<ulph::cellCurve>
    (
        ulph::cellLayout(sample.D, lower, upper, cellSize)
    );

    fluidClusters_.reset(new ulph::particleClusters(curve));
    wallClusters_.reset(new ulph::particleClusters(curve));
    sort(width);

    fluidList.build(fluid, reach, {fluid, {}, wall});
    wallList.build(wall, reach, {fluid, {}, {}});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

ulph::particleView Foam::pairRig::view(const int first, const int n) const
{
    ulph::particleView particles;
    particles.D = sample.D;
    particles.n = n;
    for (int k = 0; k < sample.D; ++k)
    {
        particles.x[k] = coordinates_[k].data() + first;
    }
    return particles;
}


void Foam::pairRig::copyOut()
{
    for (int k = 0; k < 3; ++k)
    {
        coordinates_[k].clear();
        for (const vec& x : sample.x)
        {
            coordinates_[k].push_back(x[k]);
        }
    }
    const int nWall = sample.size() - sample.nFluid;
    fluid = {fluidClusters_.get(), view(0, sample.nFluid), 0};
    wall = {wallClusters_.get(), view(sample.nFluid, nWall), sample.nFluid};
}


void Foam::pairRig::sort(const int width)
{
    copyOut();
    ulph::particleOrder order(fluidClusters_->sort(fluid.particles, width));
    for (const int i : wallClusters_->sort(wall.particles, width))
    {
        order.push_back(sample.nFluid + i);
    }
    sample.permute(order);
    copyOut();
    fluidClusters_->fit(fluid.particles);
    wallClusters_->fit(wall.particles);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pairRig::renew(const std::vector<int>& which, const double reach)
{
    copyOut();
    fluidClusters_->fit(fluid.particles);
    wallClusters_->fit(wall.particles);
    fluidList.renew(which, fluid, reach, {fluid, {}, wall});
}


void Foam::pairRig::pack(ulph::pairSums& sums, const unsigned set) const
{
    sums.resize(sample.size());

    for (int i = 0; i < sample.size(); ++i)
    {
        ulph::geometryTile geometry = {};
        ulph::forceTile force = {};
        for (int k = 0; k < sample.D; ++k)
        {
            geometry.x[k][0] = force.x[k][0] = sample.x[i][k];
            geometry.v[k][0] = force.v[k][0] = sample.v[i][k];
            force.gradientOrVelocity[k][0] =
                set & ulph::divergenceSums
              ? sample.v[i][k]
              : sample.V[i]*sample.g[i][k];
            for (int l = k; l < sample.D; ++l)
            {
                force.K[ulph::symmetricIndex(sample.D, k, l)][0] =
                    sample.K[i](k, l);
            }
        }
        geometry.V[0] = force.V[0] = sample.V[i];
        geometry.s[0] = sample.s[i];
        force.p[0] = sample.p[i];

        sums.pack(i, 1, geometry);
        sums.pack(i, 1, force);
    }
}


// ************************************************************************* //
