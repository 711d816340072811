/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Which wall particles there are, and where.

\*---------------------------------------------------------------------------*/

#include "wallLayer.H"

#include "pointGrid.H"
#include "symmetric.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Bounds of a box that is moved
static boundBox moved(const boundBox& box, const linearMap& map)
{
    pointField corners(box.points());
    for (point& corner : corners)
    {
        corner = map(corner);
    }
    return boundBox(corners, false);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::wallLayer::markOccupied
(
    const ulph::cellLayout& cells,
    const scalar reach
)
{
    // Images too: the load on a wall is counted where the wall is
    const ulph::particleView fluid(cloud_.totalView());
    const std::array<int, 3> n{cells.extent(0), cells.extent(1), cells.extent(2)};

    occupied_.assign(cells.nCells(), 0);
    #pragma omp parallel for schedule(static)
    for (int i = 0; i < fluid.n; ++i)
    {
        #pragma omp atomic write
        occupied_[cells.cellOf(fluid, i)] = 1;
    }

    // Spread by the reach, one direction after the other
    const int width = int(std::ceil(reach/cells.size()));
    const std::array<std::size_t, 3> stride{1, std::size_t(n[0]), std::size_t(n[0])*n[1]};
    for (int d = 0; d < cells.D(); ++d)
    {
        const int e = (d + 1)%3;
        const int f = (d + 2)%3;
        std::vector<unsigned char> line(n[d]);
        #pragma omp parallel for schedule(static) firstprivate(line)
        for (int b = 0; b < n[f]; ++b)
        {
            for (int a = 0; a < n[e]; ++a)
            {
                unsigned char* const cell =
                    occupied_.data() + a*stride[e] + b*stride[f];
                int last = -width - 1;
                for (int i = 0; i < n[d]; ++i)
                {
                    last = cell[i*stride[d]] ? i : last;
                    line[i] = i - last <= width;
                }
                last = n[d] + width;
                for (int i = n[d] - 1; i >= 0; --i)
                {
                    last = cell[i*stride[d]] ? i : last;
                    line[i] |= last - i <= width;
                }
                for (int i = 0; i < n[d]; ++i)
                {
                    cell[i*stride[d]] = line[i];
                }
            }
        }
    }
}


bool Foam::wallLayer::inReach
(
    const ulph::cellLayout& cells,
    const boundBox& box
) const
{
    std::array<int, 3> lower{0, 0, 0};
    std::array<int, 3> upper{0, 0, 0};
    for (int k = 0; k < cells.D(); ++k)
    {
        lower[k] = cells.coordinate(k, box.min()[cloud_.axis(k)]);
        upper[k] = cells.coordinate(k, box.max()[cloud_.axis(k)]);
    }
    for (int k = lower[2]; k <= upper[2]; ++k)
    {
        for (int j = lower[1]; j <= upper[1]; ++j)
        {
            const unsigned char* const row =
                occupied_.data()
              + (std::size_t(k)*cells.extent(1) + j)*cells.extent(0);
            if
            (
                std::find(row + lower[0], row + upper[0] + 1, 1)
             != row + upper[0] + 1
            )
            {
                return true;
            }
        }
    }
    return false;
}


void Foam::wallLayer::gather(const ulph::cellLayout& cells)
{
    // As near to each other as particles of one body may be
    pointGrid before(0.7*cloud_.dx());

    chosen_.clear();
    body_.clear();
    forAll(bodies_, b)
    {
        if (!bodies_[b].hasWalls())
        {
            continue;
        }
        const wallParticleSet& all = bodies_[b].particles().active();
        const std::size_t first = chosen_.size();
        near_.resize(all.size());
        #pragma omp parallel for schedule(static)
        for (label i = 0; i < all.size(); ++i)
        {
            const point p(placed_[b].toGround(all.position[i]));
            near_[i] = inReach(cells, boundBox(p, p)) && (b == 0 || !before.any(p));
        }
        for (label i = 0; i < all.size(); ++i)
        {
            if (near_[i])
            {
                chosen_.push_back(i);
            }
        }
        body_.resize(chosen_.size(), b);
        for (std::size_t i = first; b + 1 < bodies_.size() && i < chosen_.size(); ++i)
        {
            before.append(placed_[b].toGround(all.position[chosen_[i]]));
        }
    }

    const label n = label(chosen_.size());
    for (particleField* field : {&x_, &volume_, &reflection_, &depth_})
    {
        field->reset(n);
    }
    #pragma omp parallel for schedule(static)
    for (label i = 0; i < n; ++i)
    {
        const wallParticleSet& all = bodies_[body_[i]].particles().active();
        const linearMap& toGround = placed_[body_[i]].toGround;
        const symmTensor& R = all.reflection[chosen_[i]];
        const vector& n = all.normal[chosen_[i]];
        volume_.set(i, 0, all.volume[chosen_[i]]);
        depth_.set(i, 0, 0.5*all.distance[chosen_[i]]*mag(n - (R & n)));
        put
        (
            i,
            toGround(all.position[chosen_[i]]),
            bodies_[body_[i]].moves() ? transform(toGround.perLength, R) : R
        );
    }
}


Foam::symmTensor Foam::wallLayer::reflection(const label i) const
{
    const int D = cloud_.D();
    symmTensor R(symmTensor::I);
    for (int k = 0; k < D; ++k)
    {
        for (int l = k; l < D; ++l)
        {
            R[ulph::symmetricIndex(3, cloud_.axis(k), cloud_.axis(l))] =
                reflection_(i, ulph::symmetricIndex(D, k, l));
        }
    }
    return R;
}


void Foam::wallLayer::put(const label i, const point& p, const symmTensor& R)
{
    const int D = cloud_.D();
    for (int k = 0; k < D; ++k)
    {
        x_.set(i, k, p[cloud_.axis(k)]);
        for (int l = k; l < D; ++l)
        {
            reflection_.set
            (
                i,
                ulph::symmetricIndex(D, k, l),
                R[ulph::symmetricIndex(3, cloud_.axis(k), cloud_.axis(l))]
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::wallLayer::move(const scalar t)
{
    bodies_.setTime(t);
    for (label b = 1; b < bodies_.size(); ++b)
    {
        const wallBody::placement& now = bodies_[b].now();
        const linearMap moved(now.toGround.after(placed_[b].toBody));
        for (label i = 0; i < size(); ++i)
        {
            if (body_[i] != b)
            {
                continue;
            }
            put
            (
                i, moved(position(i)), transform(moved.perLength, reflection(i))
            );
        }
        placed_[b] = now;
    }
}


Foam::scalar Foam::wallLayer::way
(
    const std::vector<wallBody::placement>& since
) const
{
    scalar longest = 0;
    forAll(bodies_, b)
    {
        longest = max(longest, bodies_[b].way(since[b]));
    }
    return longest;
}


Foam::label Foam::wallLayer::patch(const label i) const
{
    return bodies_[body_[i]].particles().active().patch[chosen_[i]];
}


Foam::point Foam::wallLayer::nearestOnWall(const label i) const
{
    const wallParticleSet& all = bodies_[body_[i]].particles().active();
    const label j = chosen_[i];
    return placed_[body_[i]].toGround
    (
        all.position[j] - all.distance[j]*all.normal[j]
    );
}


void Foam::wallLayer::update(const ulph::cellLayout& cells, const scalar reach)
{
    if (!any())
    {
        return;
    }
    markOccupied(cells, reach);
    forAll(bodies_, b)
    {
        if (!bodies_[b].hasWalls())
        {
            continue;
        }
        const linearMap& toGround = placed_[b].toGround;
        bodies_[b].particles().update
        (
            [&](const boundBox& box)
            {
                return inReach
                (
                    cells,
                    bodies_[b].moves() ? moved(box, toGround) : box
                );
            }
        );
    }
    gather(cells);

    for (particleField* field : {&v_, &viscousV_, &densityExcess_, &bodyForce_})
    {
        field->reset(size());
    }
}


void Foam::wallLayer::permute(const ulph::particleOrder& order)
{
    x_.permute(order);
    volume_.permute(order);
    reflection_.permute(order);
    depth_.permute(order);
    ulph::permute(chosen_.data(), order);
    ulph::permute(body_.data(), order);
}


// ************************************************************************* //
