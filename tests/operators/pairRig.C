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
    const double longest,
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
    }
    const auto cells = std::make_shared<ulph::cellLayout>
    (
        sample.D, lower, upper, cellSize
    );

    fluidGrid_.reset(new ulph::cellGrid(cells));
    wallGrid_.reset(new ulph::cellGrid(cells));
    sort();

    const int nWall = sample.size() - sample.nFluid;
    fluid = {fluidGrid_.get(), view(0, sample.nFluid), 0};
    wall = {wallGrid_.get(), view(sample.nFluid, nWall), sample.nFluid};

    fluidList.build(fluid, width, reach, longest, {fluid, {}, wall});
    wallList.build(wall, width, reach, longest, {fluid, {}, {}});
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


void Foam::pairRig::sort()
{
    const auto copyOut = [&]()
    {
        for (int k = 0; k < 3; ++k)
        {
            coordinates_[k].clear();
            for (const vec& x : sample.x)
            {
                coordinates_[k].push_back(x[k]);
            }
        }
    };
    copyOut();

    const int nFluid = sample.nFluid;
    std::vector<int> order(fluidGrid_->sort(view(0, nFluid)));
    for (const int i : wallGrid_->sort(view(nFluid, sample.size() - nFluid)))
    {
        order.push_back(nFluid + i);
    }
    sample.permute(order);
    copyOut();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pairRig::pack(ulph::pairSums& sums) const
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
            force.g[k][0] = sample.g[i][k];
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
