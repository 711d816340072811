/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepTools.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::stepTools::measureExcess()
{
    const ulphCloud& cloud = rates_.cloud();
    const double* const rho1 = cloud.densityExcess().component(0);
    scalar largest = 0;

    #pragma omp parallel for schedule(static) reduction(max : largest)
    for (label i = 0; i < cloud.size(); ++i)
    {
        const scalar error = std::abs(rho1[i]);
        largest = error > largest ? error : largest;
    }
    maxExcess_ = returnReduce(largest, maxOp<scalar>());
}


Foam::energyBudget* Foam::stepTools::budget() const
{
    return predicting_ ? nullptr : energyBudget::find(rates_.cloud().mesh());
}


Foam::energyBudget* Foam::stepTools::contactBudget() const
{
    return contact_.hasWalls() ? budget() : nullptr;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stepTools::stepTools
(
    rightHandSide& rates,
    wallContact& contact,
    const wallMotion& motion,
    const guard& check
)
:
    rates_(rates),
    contact_(contact),
    motion_(motion),
    guard_(check)
{
    measureSpeed(rates.cloud().mesh().time().value());
    measureExcess();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepTools::measureSpeed(const scalar t)
{
    const linearMap walls(motion_.velocity(t));
    const ulphCloud& cloud = rates_.cloud();
    scalar max2 = 0;

    #pragma omp parallel for schedule(static) reduction(max : max2)
    for (label first = 0; first < cloud.size(); first += ulph::maxLanes)
    {
        const label n = min(label(ulph::maxLanes), cloud.size() - first);
        ulph::laneRow v2 = {};
        ulph::laneRow wallV[3];
        walls.rows(cloud, cloud.x(), nullptr, first, n, wallV);
        for (int k = 0; k < cloud.D(); ++k)
        {
            const double* const v = cloud.v().component(k) + first;
            ulph::forLanes(n, [&](const int l)
            {
                v2[l] += sqr(v[l] - wallV[k][l]);
            });
        }
        for (label l = 0; l < n; ++l)
        {
            max2 = v2[l] > max2 ? v2[l] : max2;
        }
    }
    maxSpeed_ = returnReduce(std::sqrt(max2), maxOp<scalar>());
}


bool Foam::stepTools::updateNeighbours(const scalar t)
{
    energyBudget::change work
    (
        contactBudget(), energyBudget::contact, &energyBudget::potential
    );
    return rates_.updateNeighbours(t);
}


void Foam::stepTools::drift
(
    const scalar t,
    const scalar dt,
    const scalar tVelocity
)
{
    ledger::section timer(rates_.times(), "integration");
    ulphCloud& cloud = rates_.cloud();
    {
        energyBudget::change work
        (
            contactBudget(), energyBudget::contact, &energyBudget::kinetic
        );
        contact_.limitVelocity(t, dt, motion_.velocity(tVelocity));
    }

    const linearMap drifted(motion_.drift(t, dt, tVelocity));
    forTiles(cloud.size(), [&](const label first, const label n)
    {
        ulph::laneRow x[3];
        drifted.rows(cloud, cloud.x(), &cloud.v(), first, n, x);
        cloud.x().store(first, n, x);
    });
}


void Foam::stepTools::kick
(
    const scalar t,
    const scalar dt,
    const tensor& perVelocity
)
{
    ledger::section timer(rates_.times(), "integration");
    ulphCloud& cloud = rates_.cloud();
    const int D = cloud.D();
    const particleField& a = *cloud.derived("acceleration");

    // A sum does not lose a value that is not finite, as a maximum may
    scalar max2 = 0;
    scalar sum2 = 0;

    #pragma omp parallel for schedule(static) \
        reduction(max : max2) reduction(+ : sum2)
    for (label first = 0; first < cloud.size(); first += ulph::maxLanes)
    {
        const label n = min(label(ulph::maxLanes), cloud.size() - first);
        ulph::laneRow rows[3];
        a.load(first, n, rows);
        for (label l = 0; l < n; ++l)
        {
            scalar a2 = 0;
            for (int k = 0; k < D; ++k)
            {
                a2 += sqr(rows[k][l]);
            }
            max2 = a2 > max2 ? a2 : max2;
            sum2 += a2;
        }
    }
    guard_.checkRates(std::isfinite(sum2), {"acceleration"});
    maxAcceleration_ = returnReduce(std::sqrt(max2), maxOp<scalar>());

    const tensor change(dt*inv(tensor::I - 0.5*dt*perVelocity));
    forTiles(cloud.size(), [&](const label first, const label n)
    {
        ulph::laneRow rows[3];
        a.load(first, n, rows);
        for (int k = 0; k < D; ++k)
        {
            double* const v = cloud.v().component(k) + first;
            for (int m = 0; m < D; ++m)
            {
                const scalar factor = change(cloud.axis(k), cloud.axis(m));
                if (factor != 0)
                {
                    ulph::forLanes(n, [&](const int l)
                    {
                        v[l] += factor*rows[m][l];
                    });
                }
            }
        }
    });
    if (energyBudget* const book = budget())
    {
        book->addKick(dt);
    }
    measureSpeed(t + dt);
}


void Foam::stepTools::advanceDensity
(
    const scalar dtAfterKick,
    const scalar dt
)
{
    ledger::section timer(rates_.times(), "integration");
    ulphCloud& cloud = rates_.cloud();
    const particleField& divergence = *cloud.derived("divergence");
    const particleField* const diffusion = cloud.derived("densityDiffusion");
    const particleField* const neighbourDiffusion =
        cloud.saved("neighbourDiffusion");
    const particleField* const relaxation = cloud.derived("densityRelaxation");
    const particleField& afterKick =
        cloud.saved("divergenceAfterKick")
      ? *cloud.saved("divergenceAfterKick")
      : divergence;
    const scalar total = dtAfterKick + dt;
    const freeSurface& surface = *rates_.models().surface;
    energyBudget* const book = budget();
    const scalar rho0 = cloud.rho0();
    double* const rho1 = cloud.densityExcess().component(0);

    scalar max = 0;
    scalar sum = 0;

    #pragma omp parallel for schedule(static) \
        reduction(max : max) reduction(+ : sum)
    for (label first = 0; first < cloud.size(); first += ulph::maxLanes)
    {
        const label n = Foam::min(label(ulph::maxLanes), cloud.size() - first);
        ulph::laneRow div0;
        ulph::laneRow div;
        ulph::laneRow diffused = {};
        ulph::laneRow relaxed = {};
        ulph::laneRow held;
        afterKick.load(0, first, n, div0);
        divergence.load(0, first, n, div);
        if (diffusion)
        {
            diffusion->load(0, first, n, diffused);
        }
        if (neighbourDiffusion)
        {
            ulph::laneRow part;
            neighbourDiffusion->load(0, first, n, part);
            ulph::forLanes(n, [&](const int l) { diffused[l] += part[l]; });
        }
        if (relaxation)
        {
            relaxation->load(0, first, n, relaxed);
            surface.keepInside(first, n, relaxed);
        }
        double* const excess = rho1 + first;
        if (book)
        {
            std::copy_n(excess, n, held);
        }
        ulph::laneRow change;
        scalar sumOfTile = 0;
        ulph::forLanes(n, [&](const int l)
        {
            change[l] =
                total*(diffused[l] + relaxed[l])
              - (rho0 + excess[l])*(dtAfterKick*div0[l] + dt*div[l]);
        });
        for (label l = 0; l < n; ++l)
        {
            sumOfTile += std::abs(change[l]);
        }
        sum += sumOfTile;
        if (!std::isfinite(sumOfTile))
        {
            continue;
        }
        ulph::forLanes(n, [&](const int l) { excess[l] += change[l]; });
        if (book)
        {
            book->addDensity
            (
                first, n, total, diffused, relaxed, held, excess
            );

            std::copy_n(excess, n, held);
        }
        surface.release(first, n, excess);
        if (book)
        {
            book->addRelease(first, n, held, excess);
        }
        for (label l = 0; l < n; ++l)
        {
            const scalar error = std::abs(excess[l]);
            max = error > max ? error : max;
        }
    }
    guard_.checkRates
    (
        std::isfinite(sum),
        {"divergence", "densityDiffusion", "densityRelaxation"}
    );
    maxExcess_ = returnReduce(max, maxOp<scalar>());
}


void Foam::stepTools::shift(const scalar t, const scalar dt)
{
    const shifting& model = *rates_.models().shift;
    if (model.off())
    {
        return;
    }
    ledger::section timer(rates_.times(), "shifting");
    ulphCloud& cloud = rates_.cloud();
    const scalar VmaxDt = maxSpeed_*dt;

    {
        energyBudget::change work
        (
            budget(), energyBudget::shifting, &energyBudget::potential
        );
        forTiles(cloud.size(), [&](const label first, const label n)
        {
            ulph::laneRow dx[3];
            model.displacement(VmaxDt, first, n, dx);
            for (int k = 0; k < cloud.D(); ++k)
            {
                double* const x = cloud.x().component(k) + first;
                for (label l = 0; l < n; ++l)
                {
                    x[l] += dx[k][l];
                }
            }
        });
    }
    energyBudget::change work
    (
        contactBudget(), energyBudget::contact, &energyBudget::potential
    );
    contact_.limitPosition(t);
}


void Foam::stepTools::finish()
{
    guard_.checkState(maxSpeed_, maxExcess_);
    kept_ = false;
    if (energyBudget* const book = budget())
    {
        book->addBodyForce();
    }
}


// ************************************************************************* //
