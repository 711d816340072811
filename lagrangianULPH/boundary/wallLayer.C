/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallLayer.H"

#include "symmetric.H"
#include "fvMesh.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Component k of a - R a: twice the part normal to the wall
static void lessReflected
(
    const int D,
    const int count,
    const ulph::laneRow* R,
    const ulph::laneRow* a,
    const int k,
    ulph::laneRow& row
)
{
    ulph::forLanes(count, [&](const int l) { row[l] = a[k][l]; });
    for (int m = 0; m < D; ++m)
    {
        const ulph::laneRow& Rkm = R[ulph::symmetricIndex(D, k, m)];
        ulph::forLanes(count, [&](const int l) { row[l] -= Rkm[l]*a[m][l]; });
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::wallLayer::velocityOfBodies
(
    const label first,
    const label count,
    ulph::laneRow* v
) const
{
    for (label l = 0; l < count; ++l)
    {
        vector own(Zero);
        if (bodies_[body_[first + l]].moves())
        {
            own = bodyVelocity_[body_[first + l]](position(first + l));
        }
        for (int k = 0; k < cloud_.D(); ++k)
        {
            v[k][l] = own[cloud_.axis(k)];
        }
    }
}


void Foam::wallLayer::addTurning
(
    const ulph::interpolationBlock& sums,
    const ulph::laneRow& perWeight,
    ulph::laneRow* fluid
) const
{
    for (int l = 0; l < sums.count; ++l)
    {
        const label i = sums.first - firstRecord + l;
        const tensor& gradient = bodyVelocity_[body_[i]].perLength;
        for (int k = 0; k < cloud_.D(); ++k)
        {
            for (int m = 0; m < cloud_.D(); ++m)
            {
                fluid[k][l] -=
                    gradient(cloud_.axis(k), cloud_.axis(m))
                   *sums.x[m][l]*perWeight[l];
            }
        }
    }
}


void Foam::wallLayer::depthOverHeight
(
    const ulph::interpolationBlock& sums,
    const ulph::laneRow& perWeight,
    const ulph::laneRow* R,
    ulph::laneRow& ratio
) const
{
    const int D = cloud_.D();
    // Fluid keeps half a spacing off; held to what single particles nearer than
    // that do, walls are too stiff for the time step
    const scalar least = 0.5*cloud_.dx();

    ulph::laneRow depth;
    depth_.load(0, sums.first - firstRecord, sums.count, depth);

    ulph::laneRow apart = {};
    for (int k = 0; k < D; ++k)
    {
        ulph::laneRow twiceNormal;
        lessReflected(D, sums.count, R, sums.x, k, twiceNormal);
        ulph::forLanes(sums.count, [&](const int l) { apart[l] += sqr(twiceNormal[l]); });
    }
    ulph::forLanes(sums.count, [&](const int l)
    {
        const scalar height = 0.5*std::sqrt(apart[l])*perWeight[l] - depth[l];
        ratio[l] = depth[l]/max(height, least);
    });
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
    depth_(1, cloud.shared().mixed),
    v_(cloud.D(), cloud.shared().mixed),
    viscousV_(cloud.D(), cloud.shared().mixed),
    densityExcess_(1, false),
    bodyForce_(cloud.D(), cloud.shared().mixed),
    placed_(bodies.size()),
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


void Foam::wallLayer::takeVelocity
(
    const ulph::interpolationBlock& sums,
    const ulph::laneRow& perWeight
)
{
    const int D = cloud_.D();
    const label first = sums.first - firstRecord;

    // The fluid relative to the wall
    const bool bodiesMove = bodies_.size() > 1;
    ulph::laneRow bodyV[3] = {};
    if (bodiesMove)
    {
        velocityOfBodies(first, sums.count, bodyV);
    }
    ulph::laneRow fluid[3];
    for (int k = 0; k < D; ++k)
    {
        ulph::forLanes(sums.count, [&](const int l)
        {
            fluid[k][l] = sums.v[k][l]*perWeight[l] - bodyV[k][l];
        });
    }
    if (bodiesMove)
    {
        addTurning(sums, perWeight, fluid);
    }

    ulph::laneRow R[6];
    reflection_.load(first, sums.count, R);
    ulph::laneRow ratio;
    depthOverHeight(sums, perWeight, R, ratio);
    ulph::laneRow v[3];
    for (int k = 0; k < D; ++k)
    {
        ulph::laneRow twiceNormal;
        lessReflected(D, sums.count, R, fluid, k, twiceNormal);
        ulph::forLanes(sums.count, [&](const int l)
        {
            v[k][l] = fluid[k][l] - 0.5*(1 + ratio[l])*twiceNormal[l];
        });
    }
    ulph::laneRow viscousV[3];
    model_.viscousVelocity(sums.count, fluid, v, viscousV);

    ulph::laneRow tankV[3];
    velocity_.rows(cloud_, x_, nullptr, first, sums.count, tankV);
    for (int k = 0; k < D; ++k)
    {
        ulph::forLanes(sums.count, [&](const int l)
        {
            v[k][l] += bodyV[k][l];
            viscousV[k][l] += bodyV[k][l] + tankV[k][l];
        });
    }
    v_.store(first, sums.count, v);
    viscousV_.store(first, sums.count, viscousV);
}


void Foam::wallLayer::takePressure
(
    const ulph::interpolationBlock& sums,
    const ulph::laneRow& perWeight
)
{
    const label first = sums.first - firstRecord;
    const scalar rho0 = cloud_.rho0();

    ulph::laneRow rho1;
    ulph::laneRow p;
    ulph::forLanes(sums.count, [&](const int l) { rho1[l] = sums.s[l]*perWeight[l]; });
    state_.pressure(sums.count, rho1, p);

    ulph::laneRow f[3];
    bodyForce_.load(first, sums.count, f);
    ulph::laneRow balance = {};
    for (int k = 0; k < cloud_.D(); ++k)
    {
        ulph::forLanes(sums.count, [&](const int l)
        {
            balance[l] -= f[k][l]*(rho0*sums.x[k][l] + sums.sx[k][l])*perWeight[l];
        });
    }
    label nSeparated = 0;
    for (int l = 0; l < sums.count; ++l)
    {
        const bool separated = isSeparated(p[l], balance[l]);
        p[l] += separated ? 0 : balance[l];
        nSeparated += separated;
    }
    if (nSeparated)
    {
        #pragma omp atomic
        nSeparated_ += nSeparated;
    }
    state_.densityExcess(sums.count, p, rho1);
    densityExcess_.store(0, first, sums.count, rho1);
}


void Foam::wallLayer::take(const ulph::interpolationBlock& sums)
{
    // Listed for what may come, as most are under a splash
    if (std::all_of(sums.w, sums.w + sums.count, [](const scalar w) { return w == 0; }))
    {
        const label first = sums.first - firstRecord;
        const ulph::laneRow zero[3] = {};
        if (sums.taken & ulph::velocityAverages)
        {
            v_.store(first, sums.count, zero);
            viscousV_.store(first, sums.count, zero);
        }
        if (sums.taken & ulph::scalarAverages)
        {
            densityExcess_.store(0, first, sums.count, zero[0]);
        }
        return;
    }

    ulph::laneRow perWeight;
    ulph::forLanes(sums.count, [&](const int l)
    {
        perWeight[l] = sums.w[l] > VSMALL ? 1/sums.w[l] : 0;
    });
    if (sums.taken & ulph::velocityAverages)
    {
        takeVelocity(sums, perWeight);
    }
    if (sums.taken & ulph::scalarAverages)
    {
        takePressure(sums, perWeight);
    }
}


void Foam::wallLayer::report(Ostream& os) const
{
    os  << "    walls: did not hold fluid without pressure "
        << returnReduce(nSeparated_, sumOp<label>()) << " times" << nl;
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
    loadDensityExcess(first, count, tile.s);
    loadVelocity(first, count, tile.v);
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
    bodyForce_.load(first, count, tile.gradientOrVelocity);
    for (label l = 0; l < count; ++l)
    {
        for (int k = 0; k < D; ++k)
        {
            tile.gradientOrVelocity[k][l] *=
                cloud_.rho0()/sqr(cloud_.c0())*tile.V[l];
            for (int m = k; m < D; ++m)
            {
                tile.K[ulph::symmetricIndex(D, k, m)][l] = k == m ? inverseMoment() : 0;
            }
        }
    }
}


// ************************************************************************* //
