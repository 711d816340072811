/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "oscillatingDropletExact.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace exactFields
{
    defineTypeNameAndDebug(oscillatingDropletExact, 0);
    addToRunTimeSelectionTable(exactField, oscillatingDropletExact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactFields::oscillatingDropletExact::oscillatingDropletExact
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    rho0_(cloud.rho0()),
    x_(cloud.axis(0)),
    y_(cloud.axis(1)),
    R_(dict.get<scalar>("R")),
    Psi_(dict.get<scalar>("Psi")),
    Omega0_(dict.get<scalar>("Omega0")),
    centre_(dict.getOrDefault<point>("centre", Zero)),
    state_(R_, Omega0_)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector2D Foam::exactFields::oscillatingDropletExact::rate
(
    const vector2D& state
) const
{
    const scalar a2 = sqr(state.x());
    const scalar b2 = pow4(R_)/a2;
    const scalar Omega = state.y();
    return vector2D
    (
        Omega*state.x(), (sqr(Omega) + sqr(Psi_))*(b2 - a2)/(a2 + b2)
    );
}


void Foam::exactFields::oscillatingDropletExact::step(const scalar dt)
{
    const vector2D k1(rate(state_));
    const vector2D k2(rate(state_ + 0.5*dt*k1));
    const vector2D k3(rate(state_ + 0.5*dt*k2));
    const vector2D k4(rate(state_ + dt*k3));
    state_ += dt/6*(k1 + 2*k2 + 2*k3 + k4);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::exactFields::oscillatingDropletExact::setTime(const scalar t)
{
    if (t < t_)
    {
        t_ = 0;
        state_ = vector2D(R_, Omega0_);
    }
    const scalar largest = 1e-3/max(mag(Psi_), mag(Omega0_));
    const label n = label(std::ceil((t - t_)/largest));
    for (label i = 0; i < n; ++i)
    {
        step((t - t_)/n);
    }
    t_ = t;
}


Foam::vector Foam::exactFields::oscillatingDropletExact::U(const point& x) const
{
    vector U(Zero);
    U[x_] = state_.y()*(x[x_] - centre_[x_]);
    U[y_] = -state_.y()*(x[y_] - centre_[y_]);
    return U;
}


Foam::scalar Foam::exactFields::oscillatingDropletExact::p(const point& x) const
{
    const scalar a2 = sqr(state_.x());
    const scalar b2 = pow4(R_)/a2;
    return
        rho0_*(sqr(state_.y()) + sqr(Psi_))*a2*b2/(a2 + b2)
       *(1 - sqr(x[x_] - centre_[x_])/a2 - sqr(x[y_] - centre_[y_])/b2);
}


// ************************************************************************* //
