/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Add a multiple of one field to another, a tile of both
static void addTo
(
    const particleField& from,
    const scalar s,
    const label first,
    const label n,
    particleField& to
)
{
    ulph::laneRow rows[3];
    ulph::laneRow added[3];
    to.load(first, n, rows);
    from.load(first, n, added);
    for (int c = 0; c < to.nComponents(); ++c)
    {
        ulph::forLanes(n, [&](const int l) { rows[c][l] += s*added[c][l]; });
    }
    to.store(first, n, rows);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::array<Foam::stepTools::keptField, 3> Foam::stepTools::keptFields()
{
    ulphCloud& cloud = rates_.cloud();
    return
    {{
        {cloud.x(), cloud.requireState("xKept", cloud.D())},
        {cloud.v(), cloud.requireState("vKept", cloud.D())},
        {cloud.densityExcess(), cloud.requireState("densityExcessKept", 1)}
    }};
}


Foam::particleField& Foam::stepTools::toSavedVelocity()
{
    ulphCloud& cloud = rates_.cloud();
    return cloud.requireState("toSavedV", cloud.D(), cloud.shared().mixed);
}


Foam::particleField& Foam::stepTools::toSavedDensity()
{
    return rates_.cloud().requireState("toSavedDensityExcess", 1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepTools::keep(const scalar dt)
{
    kept_ = guard_.strained(maxSpeed_, maxExcess_, dt);
    densityLagKept_ = densityLag_;
    if (kept_)
    {
        for (const keptField& field : keptFields())
        {
            field.kept = field.now;
        }
    }
}


bool Foam::stepTools::restore()
{
    if (kept_)
    {
        for (const keptField& field : keptFields())
        {
            field.now = field.kept;
        }
        densityLag_ = densityLagKept_;
    }
    return kept_;
}


void Foam::stepTools::save(const scalar half)
{
    ulphCloud& cloud = rates_.cloud();
    toSavedDensity() = cloud.densityExcess();

    const particleField& a = *cloud.derived("acceleration");
    particleField& toSavedV = toSavedVelocity();
    forTiles(cloud.size(), [&](const label first, const label n)
    {
        ulph::laneRow change[3];
        a.load(first, n, change);
        for (int k = 0; k < cloud.D(); ++k)
        {
            ulph::forLanes(n, [&](const int l) { change[k][l] *= -half; });
        }
        toSavedV.store(first, n, change);
    });
    predicting_ = true;
}


void Foam::stepTools::advanceSaved(const scalar t, const scalar dt)
{
    ulphCloud& cloud = rates_.cloud();
    const particleField& toSavedV = toSavedVelocity();
    particleField& toSavedRho1 = toSavedDensity();
    const linearMap back(motion_.drift(t, 0.5*dt, t).back());

    forTiles(cloud.size(), [&](const label first, const label n)
    {
        addTo(cloud.densityExcess(), -1, first, n, toSavedRho1);
        addTo(toSavedV, 1, first, n, cloud.v());
        ulph::laneRow x[3];
        back.rows(cloud, cloud.x(), &cloud.v(), first, n, x);
        cloud.x().store(first, n, x);
        addTo(toSavedV, -1, first, n, cloud.v());
    });
    predicting_ = false;
    if (energyBudget* const book = budget())
    {
        book->setOffset(&toSavedV, &toSavedRho1);
    }

    drift(t, dt, t + 0.5*dt);
    advanceDensity(0, dt);
    kick(t, dt);
    forTiles(cloud.size(), [&](const label first, const label n)
    {
        addTo(toSavedV, 1, first, n, cloud.v());
        addTo(toSavedRho1, 1, first, n, cloud.densityExcess());
    });
    if (energyBudget* const book = budget())
    {
        book->setOffset(nullptr, nullptr);
    }
    measureSpeed(t + dt);
    measureExcess();
}


// ************************************************************************* //
