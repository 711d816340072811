/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
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
    const ulph::cellGrid& fluid,
    const scalar reach
)
{
    const ulph::cellLayout& cells = fluid.layout();
    const std::array<int, 3> n{cells.extent(0), cells.extent(1), cells.extent(2)};
    const auto index = [&](const int i, const int j, const int k)
    {
        return (std::size_t(k)*n[1] + j)*n[0] + i;
    };

    occupied_.assign(cells.nCells(), 0);
    for (int k = 0; k < n[2]; ++k)
    {
        for (int j = 0; j < n[1]; ++j)
        {
            for (int i = 0; i < n[0]; ++i)
            {
                const int r = cells.rank(i, j, k);
                occupied_[index(i, j, k)] = fluid.first(r + 1) > fluid.first(r);
            }
        }
    }

    // Spread by the reach, one direction after the other
    const int width = int(std::ceil(reach/cells.size()));
    const std::array<std::size_t, 3> stride{1, std::size_t(n[0]), std::size_t(n[0])*n[1]};
    std::vector<unsigned char> line;
    for (int d = 0; d < cells.D(); ++d)
    {
        const int e = (d + 1)%3;
        const int f = (d + 2)%3;
        line.resize(n[d]);
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

    forAll(bodies_, b)
    {
        if (!bodies_[b].hasWalls())
        {
            continue;
        }
        const wallParticleSet& all = bodies_[b].particles().active();
        const linearMap& toGround = placed_[b].toGround;

        std::vector<label> chosen;
        for (label i = 0; i < all.size(); ++i)
        {
            const point p(toGround(all.position[i]));
            if (inReach(cells, boundBox(p, p)) && (b == 0 || !before.any(p)))
            {
                chosen.push_back(i);
            }
        }
        append(b, all, chosen);
        if (b < bodies_.size() - 1)
        {
            for (const label i : chosen)
            {
                before.append(toGround(all.position[i]));
            }
        }
    }
}


void Foam::wallLayer::append
(
    const label body,
    const wallParticleSet& all,
    const std::vector<label>& chosen
)
{
    const int D = cloud_.D();
    const wallBody::placement& place = placed_[body];
    const label first = size();

    body_.resize(first + chosen.size(), body);
    for (particleField* field : {&x_, &volume_, &reflection_})
    {
        field->resize(label(body_.size()));
    }
    for (label i = first; i < size(); ++i)
    {
        const label from = chosen[i - first];
        const point p(place.toGround(all.position[from]));
        const symmTensor R
        (
            bodies_[body].moves()
          ? transform(place.toGround.perLength, all.reflection[from])
          : all.reflection[from]
        );
        volume_.set(i, 0, all.volume[from]);
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
}


void Foam::wallLayer::wallVelocity
(
    const label first,
    const label count,
    ulph::laneRow* v
) const
{
    velocity_.rows(cloud_, x_, nullptr, first, count, v);
    for (label l = 0; bodies_.size() > 1 && l < count; ++l)
    {
        const int body = body_[first + l];
        if (bodies_[body].moves())
        {
            const vector own(bodyVelocity_[body](position(first + l)));
            for (int k = 0; k < cloud_.D(); ++k)
            {
                v[k][l] += own[cloud_.axis(k)];
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallLayer::wallLayer
(
    const ulphCloud& cloud,
    wallBodies& bodies,
    const wall& model,
    const bodyForce& force,
    const wallMotion& motion,
    const equationOfState& state
)
:
    cloud_(cloud),
    bodies_(bodies),
    model_(model),
    force_(force),
    motion_(motion),
    state_(state),
    x_(cloud.D(), false),
    volume_(1, cloud.shared().mixed),
    reflection_(ulph::nSymmetric(cloud.D()), cloud.shared().mixed),
    v_(cloud.D(), cloud.shared().mixed),
    viscousV_(cloud.D(), cloud.shared().mixed),
    densityExcess_(1, false),
    bodyForce_(cloud.D(), cloud.shared().mixed),
    placed_(bodies.size()),
    updated_(bodies.size()),
    bodyVelocity_(bodies.size())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

ulph::particleView Foam::wallLayer::view() const
{
    ulph::particleView particles;
    particles.D = cloud_.D();
    particles.n = size();
    for (int k = 0; k < particles.D; ++k)
    {
        particles.x[k] = x_.component(k);
    }
    return particles;
}


Foam::point Foam::wallLayer::position(const label i) const
{
    // The empty direction is that of the mid-plane
    point p(cloud_.mesh().bounds().midpoint());
    for (int k = 0; k < cloud_.D(); ++k)
    {
        p[cloud_.axis(k)] = x_(i, k);
    }
    return p;
}


void Foam::wallLayer::move(const scalar t)
{
    bodies_.setTime(t);
    for (label b = 1; b < bodies_.size(); ++b)
    {
        const wallBody::placement& now = bodies_[b].now();
        const linearMap moved(now.toGround.after(placed_[b].toBody));
        const tensor& turned = moved.perLength;
        for (label i = 0; i < size(); ++i)
        {
            if (body_[i] != b)
            {
                continue;
            }
            const point p(moved(position(i)));
            symmTensor R(symmTensor::I);
            const int D = cloud_.D();
            for (int k = 0; k < D; ++k)
            {
                x_.set(i, k, p[cloud_.axis(k)]);
                for (int l = k; l < D; ++l)
                {
                    R[ulph::symmetricIndex(3, cloud_.axis(k), cloud_.axis(l))] =
                        reflection_(i, ulph::symmetricIndex(D, k, l));
                }
            }
            R = transform(turned, R);
            for (int k = 0; k < D; ++k)
            {
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
        placed_[b] = now;
    }
}


Foam::scalar Foam::wallLayer::way() const
{
    scalar longest = 0;
    forAll(bodies_, b)
    {
        longest = max(longest, bodies_[b].way(updated_[b]));
    }
    return longest;
}


Foam::wallSearch::wallPoint Foam::wallLayer::nearest(const label i) const
{
    const wallBody::placement& place = placed_[body_[i]];
    wallSearch::wallPoint found
    (
        bodies_[body_[i]].nearestOnBody(place.toBody(position(i)), GREAT)
    );
    found.position = place.toGround(found.position);
    found.normal = place.toGround.perLength & found.normal;
    return found;
}


void Foam::wallLayer::update(const ulph::cellGrid& fluid, const scalar reach)
{
    if (!any())
    {
        return;
    }
    const ulph::cellLayout& cells = fluid.layout();
    markOccupied(fluid, reach);
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
    body_.clear();
    for (particleField* field : {&x_, &volume_, &reflection_})
    {
        field->reset(0);
    }
    gather(cells);
    updated_ = placed_;

    for (particleField* field : {&v_, &viscousV_, &densityExcess_, &bodyForce_})
    {
        field->reset(size());
    }
}


void Foam::wallLayer::permute(const std::vector<int>& order)
{
    x_.permute(order);
    volume_.permute(order);
    reflection_.permute(order);
    const std::vector<int> before(body_);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        body_[i] = before[order[i]];
    }
}


void Foam::wallLayer::setTime(const scalar t, const scalar tVelocity)
{
    move(t);
    velocity_ = motion_.velocity(tVelocity);
    std::vector<linearMap> acceleration(bodies_.size());
    forAll(bodies_, b)
    {
        bodyVelocity_[b] = bodies_[b].velocity(tVelocity);
        acceleration[b] = bodies_[b].acceleration(t);
    }
    const linearMap force(forceAtRest(t));
    forTiles(size(), [&](const label first, const label count)
    {
        ulph::laneRow f[3];
        force.rows(cloud_, x_, nullptr, first, count, f);
        for (label l = 0; bodies_.size() > 1 && l < count; ++l)
        {
            const vector a(acceleration[body_[first + l]](position(first + l)));
            for (int k = 0; k < cloud_.D(); ++k)
            {
                f[k][l] -= a[cloud_.axis(k)];
            }
        }
        bodyForce_.store(first, count, f);
    });
}


void Foam::wallLayer::take(const ulph::interpolationBlock& sums)
{
    const int D = cloud_.D();
    const label first = sums.first - firstRecord;

    ulph::laneRow fluid[3];
    ulph::laneRow v[3];
    ulph::laneRow viscousV[3];
    ulph::laneRow R[6];
    ulph::laneRow f[3];
    ulph::laneRow rho1;
    ulph::laneRow p;

    reflection_.load(first, sums.count, R);
    bodyForce_.load(first, sums.count, f);

    ulph::laneRow wallV[3];
    wallVelocity(first, sums.count, wallV);

    for (int l = 0; l < sums.count; ++l)
    {
        const bool wet = sums.w[l] > VSMALL;
        rho1[l] = wet ? sums.s[l]/sums.w[l] : 0;
        for (int k = 0; k < D; ++k)
        {
            fluid[k][l] = wet ? sums.v[k][l]/sums.w[l] - wallV[k][l] : 0;
        }

        // What turns has another velocity where the averaged fluid is
        const tensor turns
        (
            velocity_.perLength + bodyVelocity_[body_[first + l]].perLength
        );
        if (wet && turns != tensor::zero)
        {
            for (int k = 0; k < D; ++k)
            {
                for (int m = 0; m < D; ++m)
                {
                    fluid[k][l] -=
                        turns(cloud_.axis(k), cloud_.axis(m))
                       *sums.x[m][l]/sums.w[l];
                }
            }
        }
    }

    state_.pressure(sums.count, rho1, p);
    label nSeparated = 0;
    for (int l = 0; l < sums.count; ++l)
    {
        scalar balance = 0;
        for (int k = 0; k < D && sums.w[l] > VSMALL; ++k)
        {
            balance -=
                f[k][l]*(cloud_.rho0()*sums.x[k][l] + sums.sx[k][l])/sums.w[l];
        }
        if (p[l] <= 0 && balance < 0)
        {
            balance = 0;
            ++nSeparated;
        }
        p[l] += balance;
    }
    if (nSeparated)
    {
        #pragma omp atomic
        nSeparated_ += nSeparated;
    }
    state_.densityExcess(sums.count, p, rho1);

    for (int k = 0; k < D; ++k)
    {
        for (int l = 0; l < sums.count; ++l)
        {
            v[k][l] = 0;
            for (int m = 0; m < D; ++m)
            {
                v[k][l] += R[ulph::symmetricIndex(D, k, m)][l]*fluid[m][l];
            }
        }
    }
    model_.viscousVelocity(sums.count, fluid, v, viscousV);
    for (int k = 0; k < D; ++k)
    {
        for (int l = 0; l < sums.count; ++l)
        {
            v[k][l] += wallV[k][l];
            viscousV[k][l] += wallV[k][l];
        }
    }

    densityExcess_.store(0, first, sums.count, rho1);
    v_.store(first, sums.count, v);
    viscousV_.store(first, sums.count, viscousV);
}


void Foam::wallLayer::report(Ostream& os) const
{
    os  << "    walls: did not hold fluid without pressure " << nSeparated_
        << " times" << nl;
}


void Foam::wallLayer::fill
(
    const label first,
    const label count,
    ulph::geometryTile& tile
) const
{
    x_.load(first, count, tile.x);
    volume_.load(0, first, count, tile.V);
    densityExcess_.load(0, first, count, tile.s);
    v_.load(first, count, tile.v);
}


void Foam::wallLayer::fill
(
    const label first,
    const label count,
    ulph::forceTile& tile
) const
{
    const int D = cloud_.D();

    x_.load(first, count, tile.x);
    volume_.load(0, first, count, tile.V);
    viscousV_.load(first, count, tile.v);

    ulph::laneRow rho1;
    densityExcess_.load(0, first, count, rho1);
    state_.pressure(count, rho1, tile.p);

    // The density gradient in balance with the body force
    bodyForce_.load(first, count, tile.g);
    for (label l = 0; l < count; ++l)
    {
        for (int k = 0; k < D; ++k)
        {
            tile.g[k][l] *= cloud_.rho0()/sqr(cloud_.c0());
            for (int m = k; m < D; ++m)
            {
                tile.K[ulph::symmetricIndex(D, k, m)][l] = k == m ? inverseMoment() : 0;
            }
        }
    }
}


// ************************************************************************* //
