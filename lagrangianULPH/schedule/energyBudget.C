/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "energyBudget.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(energyBudget, 0);
}

const Foam::Enum<Foam::energyBudget::effect> Foam::energyBudget::effectNames
({
    {effect::viscosity, "viscosity"},
    {effect::densityDiffusion, "densityDiffusion"},
    {effect::densityRelaxation, "densityRelaxation"},
    {effect::freeSurface, "freeSurface"},
    {effect::shifting, "shifting"},
    {effect::contact, "contact"},
    {effect::escape, "escape"},
    {effect::bodyForce, "bodyForce"}
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Potential [m^2/s^2] of all of a force but the part that has none: perVelocity,
// and what is antisymmetric in perLength
static scalar potentialOf(const linearMap& force, const point& x)
{
    return -((force.constant + 0.5*(symm(force.perLength) & x)) & x);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Value>
Foam::scalar Foam::energyBudget::sumTiles(const label n, const Value& value)
{
    scalar total = 0;

    #pragma omp parallel for schedule(static) reduction(+ : total)
    for (label first = 0; first < n; first += ulph::maxLanes)
    {
        total += value(first, min(label(ulph::maxLanes), n - first));
    }
    return total;
}


void Foam::energyBudget::velocity
(
    const int k,
    const label first,
    const label count,
    double* row
) const
{
    cloud_.v().load(k, first, count, row);
    if (vOffset_)
    {
        ulph::laneRow offset;
        vOffset_->load(k, first, count, offset);
        for (label l = 0; l < count; ++l)
        {
            row[l] += offset[l];
        }
    }
}


void Foam::energyBudget::addOffset
(
    const label first,
    const label count,
    double* row
) const
{
    if (densityOffset_)
    {
        ulph::laneRow offset;
        densityOffset_->load(0, first, count, offset);
        for (label l = 0; l < count; ++l)
        {
            row[l] += offset[l];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::energyBudget::energyBudget(const polyMesh& mesh)
:
    MeshObject<polyMesh, Foam::GeometricMeshObject, energyBudget>(mesh),
    cloud_(mesh.lookupObject<ulphCloud>(ulphCloud::cloudName)),
    models_(mesh.lookupObject<ulphModels>(ulphModels::typeName)),
    work_(Zero)
{
    if (models_.viscous->mu() > 0)
    {
        // The force pass fills it where it is there
        viscousAcceleration_ =
            &mesh.lookupObjectRef<ulphCloud>(ulphCloud::cloudName).require
            (
                "viscousAcceleration", cloud_.D()
            );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::energyBudget* Foam::energyBudget::find(const polyMesh& mesh)
{
    return mesh.getObjectPtr<energyBudget>(typeName);
}


Foam::scalar Foam::energyBudget::kinetic() const
{
    return sumTiles(cloud_.size(), [&](const label first, const label n)
    {
        scalar sum = 0;
        for (int k = 0; k < cloud_.D(); ++k)
        {
            ulph::laneRow v;
            velocity(k, first, n, v);
            for (label l = 0; l < n; ++l)
            {
                sum += 0.5*cloud_.mass()(first + l)*sqr(v[l]);
            }
        }
        return sum;
    });
}


Foam::scalar Foam::energyBudget::potential() const
{
    const linearMap force
    (
        models_.force->at(cloud_.mesh().time().value())
    );

    return sumTiles(cloud_.size(), [&](const label first, const label n)
    {
        scalar sum = 0;
        for (label i = first; i < first + n; ++i)
        {
            sum +=
                cloud_.mass()(i)*potentialOf(force, cloud_.position(i));
        }
        return sum;
    });
}


Foam::scalar Foam::energyBudget::elastic() const
{
    return sumTiles(cloud_.size(), [&](const label first, const label n)
    {
        ulph::laneRow rho1;
        cloud_.densityExcess().load(0, first, n, rho1);
        addOffset(first, n, rho1);
        scalar sum = 0;
        for (label l = 0; l < n; ++l)
        {
            sum += cloud_.mass()(first + l)*models_.state->energy(rho1[l]);
        }
        return sum;
    });
}


void Foam::energyBudget::add(const effect e, const scalar work)
{
    #pragma omp atomic
    work_[e] += work;
}


void Foam::energyBudget::setOffset
(
    const particleField* v,
    const particleField* densityExcess
)
{
    vOffset_ = v;
    densityOffset_ = densityExcess;
}


void Foam::energyBudget::addKick(const scalar dt)
{
    if (!viscousAcceleration_)
    {
        return;
    }
    const particleField& total = *cloud_.derived("acceleration");

    add
    (
        viscosity,
        sumTiles(cloud_.size(), [&](const label first, const label n)
        {
            scalar sum = 0;
            for (int k = 0; k < cloud_.D(); ++k)
            {
                ulph::laneRow v;
                ulph::laneRow a;
                ulph::laneRow viscous;
                velocity(k, first, n, v);
                total.load(k, first, n, a);
                viscousAcceleration_->load(k, first, n, viscous);
                for (label l = 0; l < n; ++l)
                {
                    sum +=
                        dt*cloud_.mass()(first + l)*viscous[l]
                       *(v[l] - 0.5*dt*a[l]);
                }
            }
            return sum;
        })
    );
}


void Foam::energyBudget::addDensity
(
    const label first,
    const label count,
    const scalar dt,
    const double* diffusion,
    const double* relaxation,
    const double* before,
    const double* after
)
{
    // So that the divergence's part is what the work of the pressure pairs with:
    // the leapfrog kicks with the densities before and after, the midpoint rule
    // has the rates of the density before
    ulph::laneRow rho1;
    for (label l = 0; l < count; ++l)
    {
        rho1[l] =
            densityOffset_
          ? before[l]
          : 0.5*(before[l] + after[l]);
    }

    ulph::laneRow p;
    models_.state->pressure(count, rho1, p);

    scalar diffused = 0;
    scalar relaxed = 0;
    for (label l = 0; l < count; ++l)
    {
        const scalar perDensity =
            dt*cloud_.mass()(first + l)*p[l]/sqr(cloud_.rho0() + rho1[l]);
        diffused += perDensity*diffusion[l];
        relaxed += perDensity*relaxation[l];
    }
    add(densityDiffusion, diffused);
    add(densityRelaxation, relaxed);
}


void Foam::energyBudget::addRelease
(
    const label first,
    const label count,
    const double* before,
    const double* after
)
{
    ulph::laneRow offset = {};
    addOffset(first, count, offset);
    for (label l = 0; l < count; ++l)
    {
        if (before[l] != after[l])
        {
            const equationOfState& state = *models_.state;
            add
            (
                freeSurface,
                cloud_.mass()(first + l)
               *(
                    state.energy(after[l] + offset[l])
                  - state.energy(before[l] + offset[l])
                )
            );
        }
    }
}


void Foam::energyBudget::addBodyForce()
{
    const Time& time = cloud_.mesh().time();
    const scalar dt = time.deltaTValue();
    const linearMap before(models_.force->at(time.value() - dt));
    const linearMap after(models_.force->at(time.value()));
    const tensor noPotential(skew(after.perLength));

    add
    (
        bodyForce,
        sumTiles(cloud_.size(), [&](const label first, const label n)
        {
            scalar sum = 0;
            for (label i = first; i < first + n; ++i)
            {
                const vector v(cloud_.toVector(cloud_.v(), i));
                const point middle(cloud_.position(i) - 0.5*dt*v);
                sum +=
                    cloud_.mass()(i)
                   *(
                        potentialOf(after, middle) - potentialOf(before, middle)
                      + dt*(v & (noPotential & middle))
                    );
            }
            return sum;
        })
    );
}


// ************************************************************************* //
