/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bareRates.H"

#include "momentTensor.H"

// * * * * * * * * * * * * * * * * * Sinks * * * * * * * * * * * * * * * * * //

namespace Foam
{

class bareRates::geometrySink
:
    public ulph::sumSink<ulph::geometryBlock>
{
    bareRates& to_;

public:

    explicit geometrySink(bareRates& to)
    :
        to_(to)
    {}

    void take(const ulph::geometryBlock& sums) override
    {
        const int D = to_.rig_.cloud.D();
        ulph::laneRow K[6];
        ulph::laneRow noSurface = {};
        to_.rig_.models.moment->invert(sums, noSurface, K);
        to_.K.store(sums.first, sums.count, K);
        to_.b.store(sums.first, sums.count, sums.b);

        ulph::laneRow div;
        const ulph::laneRow notAhead = {};
        const scalar atRest[9] = {};
        momentTensor::divergence
        (
            D, sums.count, K, sums.L, notAhead, atRest, div
        );
        to_.divergence.store(0, sums.first, sums.count, div);
    }
};


class bareRates::forceSink
:
    public ulph::sumSink<ulph::forceBlock>
{
    bareRates& to_;

public:

    explicit forceSink(bareRates& to)
    :
        to_(to)
    {}

    void take(const ulph::forceBlock& sums) override
    {
        const ulphCloud& cloud = to_.rig_.cloud;
        const int D = cloud.D();

        ulph::laneRow K[6];
        ulph::laneRow b[3];
        ulph::laneRow Kb[3];
        ulph::laneRow rho1;
        ulph::laneRow p;
        ulph::laneRow a[3];
        to_.K.load(sums.first, sums.count, K);
        to_.b.load(sums.first, sums.count, b);
        momentTensor::multiply(D, sums.count, K, b, Kb);
        cloud.densityExcess().load(0, sums.first, sums.count, rho1);
        to_.rig_.models.state->pressure(sums.count, rho1, p);

        for (int k = 0; k < D; ++k)
        {
            for (int l = 0; l < sums.count; ++l)
            {
                a[k][l] = -(sums.pressure[k][l] + p[l]*Kb[k][l]);
                a[k][l] /= cloud.rho0() + rho1[l];
            }
        }
        to_.acceleration.store(sums.first, sums.count, a);
    }
};

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bareRates::bareRates
(
    rig& parts,
    const unsigned geometrySums,
    const unsigned forceSums
)
:
    rig_(parts),
    geometrySums_(geometrySums),
    forceSums_(forceSums),
    K(ulph::nSymmetric(parts.cloud.D()), parts.cloud.shared().mixed),
    b(parts.cloud.D(), parts.cloud.shared().mixed),
    divergence(1, parts.cloud.shared().mixed),
    acceleration(parts.cloud.D(), parts.cloud.shared().mixed)
{
    for (particleField* field : {&K, &b, &divergence, &acceleration})
    {
        field->reset(parts.size());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::bareRates::geometry()
{
    const ulphCloud& cloud = rig_.cloud;
    ulph::pairSums& sums = rig_.neighbours.sums();

    forTiles(cloud.size(), [&](const label first, const label count)
    {
        ulph::geometryTile tile;
        cloud.x().load(first, count, tile.x);
        cloud.v().load(first, count, tile.v);
        cloud.densityExcess().load(0, first, count, tile.s);
        cloud.volumes(first, count, tile.V);
        sums.pack(first, count, tile);
    });
    geometrySink sink(*this);
    sums.geometry(rig_.neighbours.fluidList(), {}, geometrySums_, sink);
}


void Foam::bareRates::force()
{
    const ulphCloud& cloud = rig_.cloud;
    ulph::pairSums& sums = rig_.neighbours.sums();

    forTiles(cloud.size(), [&](const label first, const label count)
    {
        ulph::forceTile tile = {};
        ulph::laneRow rho1;
        cloud.x().load(first, count, tile.x);
        cloud.v().load(first, count, tile.v);
        cloud.volumes(first, count, tile.V);
        cloud.densityExcess().load(0, first, count, rho1);
        rig_.models.state->pressure(count, rho1, tile.p);
        K.load(first, count, tile.K);
        sums.pack(first, count, tile);
    });
    forceSink sink(*this);
    sums.force
    (
        rig_.neighbours.fluidList(), {}, forceSums_, {sqr(0.1*cloud.h())}, sink
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::bareRates::evaluate()
{
    geometry();
    force();
}


// ************************************************************************* //
