/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rightHandSide.H"
#include "rightHandSideSinks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::rightHandSide::loadVelocity
(
    const label first,
    const label count,
    ulph::laneRow* v
) const
{
    cloud_.v().load(first, count, v);
    const linearMap& tank = wall_.tankVelocity();
    if (tank.zero())
    {
        return;
    }
    ulph::laneRow tankV[3];
    tank.rows(cloud_, cloud_.x(), nullptr, first, count, tankV);
    for (int k = 0; k < cloud_.D(); ++k)
    {
        ulph::forLanes(count, [&](const int l) { v[k][l] -= tankV[k][l]; });
    }
}


void Foam::rightHandSide::copyImages()
{
    haloParticles& halo = search_.halo();
    halo.copyPositions();
    halo.copy(cloud_.v());
    halo.copy(cloud_.densityExcess());
}


void Foam::rightHandSide::packFluid()
{
    forTiles(cloud_.total(), [&](const label first, const label count)
    {
        ulph::geometryTile tile;
        cloud_.x().load(first, count, tile.x);
        loadVelocity(first, count, tile.v);
        cloud_.densityExcess().load(0, first, count, tile.s);
        cloud_.volumes(first, count, tile.V);
        search_.sums().pack(first, count, tile);
    });
}


void Foam::rightHandSide::updateWalls()
{
    if (wall_.size())
    {
        ledger::section timer(ledger_, "walls");
        forTiles(wall_.size(), [&](const label first, const label count)
        {
            ulph::geometryTile tile;
            wall_.fill(first, count, tile);
            search_.sums().pack(search_.firstWall() + first, count, tile);
        });
    }
    showWalls(ulph::scalarAverages | ulph::velocityAverages);
}


void Foam::rightHandSide::showWalls(const unsigned averages)
{
    if (!wall_.size())
    {
        return;
    }
    ledger::section timer(ledger_, "walls");

    search_.sums().interpolate(search_.wallList(), averages, wall_);
    forTiles(wall_.size(), [&](const label first, const label count)
    {
        if (averages & ulph::scalarAverages)
        {
            ulph::laneRow rho1;
            wall_.loadDensityExcess(first, count, rho1);
            search_.sums().packScalar(search_.firstWall() + first, count, rho1);
        }
        if (averages & ulph::velocityAverages)
        {
            ulph::laneRow v[3];
            wall_.loadVelocity(first, count, v);
            search_.sums().packVelocity(search_.firstWall() + first, count, v);
        }
    });
}


void Foam::rightHandSide::packForces(const bool withDivergence)
{
    ledger::section timer(ledger_, "pack");

    particleField& K = *cloud_.derived("inverseMoment");
    particleField* const gradient =
        withDivergence ? nullptr : cloud_.derived("densityGradient");
    search_.halo().copy(K);
    if (gradient)
    {
        search_.halo().copy(*gradient);
    }

    forTiles(cloud_.total(), [&](const label first, const label count)
    {
        ulph::forceTile tile;
        ulph::laneRow rho1;
        cloud_.x().load(first, count, tile.x);
        cloud_.v().load(first, count, tile.v);
        cloud_.volumes(first, count, tile.V);
        cloud_.densityExcess().load(0, first, count, rho1);
        models_.state->pressure(count, rho1, tile.p);
        K.load(first, count, tile.K);
        if (withDivergence)
        {
            loadVelocity(first, count, tile.gradientOrVelocity);
        }
        else if (gradient)
        {
            gradient->load(first, count, tile.gradientOrVelocity);
            for (int k = 0; k < cloud_.D(); ++k)
            {
                ulph::forLanes(count, [&](const int l)
                {
                    tile.gradientOrVelocity[k][l] *= tile.V[l];
                });
            }
        }
        else
        {
            for (ulph::laneRow& unused : tile.gradientOrVelocity)
            {
                std::fill_n(unused, count, 0);
            }
        }
        search_.sums().pack(first, count, tile);
    });
    forTiles(wall_.size(), [&](const label first, const label count)
    {
        ulph::forceTile tile;
        wall_.fill(first, count, tile);
        if (withDivergence)
        {
            wall_.loadVelocity(first, count, tile.gradientOrVelocity);
        }
        search_.sums().pack(search_.firstWall() + first, count, tile);
    });
}


void Foam::rightHandSide::sumForces
(
    const unsigned sums,
    accelerationSink& sink
)
{
    ledger::section timer(ledger_, "forcePass");
    timer.addPairs(search_.fluidList().nPairs());
    ulph::viscousSettings viscous;
    viscous.eta2 = sqr(models_.viscous->eta()*cloud_.h());
    search_.sums().force(search_.fluidList(), {}, sums, viscous, sink);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rightHandSide::rightHandSide
(
    ulphCloud& cloud,
    ulphModels& models,
    const schedule& plan,
    wallLayer& wall,
    neighbourSearch& search,
    wallContact& contact,
    ledger& times
)
:
    cloud_(cloud),
    models_(models),
    schedule_(plan),
    wall_(wall),
    search_(search),
    contact_(contact),
    ledger_(times)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::rightHandSide::updateNeighbours(const scalar t)
{
    ledger::section timer(ledger_, "neighbours");
    wall_.move(t);
    const bool reordered = search_.update();
    wall_.firstRecord = search_.firstWall();
    contact_.update(search_);
    return reordered;
}


void Foam::rightHandSide::geometry(const scalar t, const scalar ahead)
{
    wall_.setTime(t, t - ahead);
    {
        ledger::section timer(ledger_, "pack");
        copyImages();
        packFluid();
    }
    updateWalls();

    const bool surfaceFirst = models_.moment->needsSurface();

    if (surfaceFirst)
    {
        {
            ledger::section timer(ledger_, "surface");
            eigenvalueSink sink(cloud_, *models_.surface);
            search_.sums().geometry
            (
                search_.fluidList(), {}, ulph::momentSums, sink
            );
            models_.surface->detect(search_);
        }
        ledger::section timer(ledger_, "pack");
        packFluid();
    }
    {
        ledger::section timer(ledger_, "geometryPass");
        timer.addPairs(search_.fluidList().nPairs());
        geometrySink sink
        (
            cloud_, models_, wall_.forceAtRest(t), surfaceFirst, ahead,
            wall_.tankVelocity().perLength
        );
        search_.sums().geometry
        (
            search_.fluidList(), {}, schedule_.geometrySums(), sink
        );
    }
}


void Foam::rightHandSide::findSurface()
{
    if (!models_.surface->off() && !models_.moment->needsSurface())
    {
        ledger::section timer(ledger_, "surface");
        models_.surface->detect(search_);
    }
}


void Foam::rightHandSide::force
(
    const scalar first,
    const scalar last,
    const bool densityChanged
)
{
    if (densityChanged)
    {
        {
            ledger::section timer(ledger_, "pack");
            search_.halo().copy(cloud_.densityExcess());

            // The records of the geometry pass are read for the walls only
            forTiles
            (
                wall_.size() ? cloud_.total() : 0,
                [&](const label first, const label count)
                {
                    ulph::laneRow rho1;
                    cloud_.densityExcess().load(0, first, count, rho1);
                    search_.sums().packScalar(first, count, rho1);
                }
            );
        }
        showWalls(ulph::scalarAverages);
    }
    packForces(false);
    forceSink sink(cloud_, models_, bodyForce(first, last));
    sumForces(schedule_.forceSums(), sink);
}


void Foam::rightHandSide::frozenForce
(
    const scalar t,
    const scalar first,
    const scalar last
)
{
    wall_.setTime(t, t);
    {
        ledger::section timer(ledger_, "pack");
        copyImages();
        if (wall_.size())
        {
            packFluid();
        }
    }
    updateWalls();
    packForces(true);
    frozenForceSink sink(cloud_, models_, bodyForce(first, last));
    sumForces(schedule_.frozenForceSums(), sink);
}


void Foam::rightHandSide::forgetDivergence()
{
    particleField* const afterKick = cloud_.saved("divergenceAfterKick");
    if (!afterKick)
    {
        return;
    }
    ulph::laneRow notTaken;
    std::fill_n(notTaken, ulph::maxLanes, divergenceSink::notTaken);
    forTiles(cloud_.size(), [&](const label first, const label count)
    {
        afterKick->store(0, first, count, notTaken);
    });
}


void Foam::rightHandSide::divergence(const scalar t, const scalar later)
{
    forgetDivergence();
    if (!cloud_.saved("divergenceAfterKick"))
    {
        return;
    }
    search_.halo().copy(cloud_.v());
    if (!wall_.size())
    {
        return;
    }
    wall_.setTime(t, t + later);
    {
        ledger::section timer(ledger_, "pack");
        forTiles(cloud_.total(), [&](const label first, const label count)
        {
            ulph::laneRow v[3];
            loadVelocity(first, count, v);
            search_.sums().packVelocity(first, count, v);
        });
    }
    showWalls(ulph::velocityAverages);

    ledger::section timer(ledger_, "divergencePass");
    ulph::passRange range;
    range.besideWalls = true;
    divergenceSink sink(cloud_);
    search_.sums().geometry
    (
        search_.fluidList(), range, ulph::velocityGradientSums, sink
    );
}


// ************************************************************************* //
