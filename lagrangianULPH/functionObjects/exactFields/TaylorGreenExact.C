/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "TaylorGreenExact.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace exactFields
{
    defineTypeNameAndDebug(TaylorGreenExact, 0);
    addToRunTimeSelectionTable(exactField, TaylorGreenExact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactFields::TaylorGreenExact::TaylorGreenExact
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    rho0_(cloud.rho0()),
    x_(cloud.axis(0)),
    y_(cloud.axis(1)),
    U0_(dict.get<scalar>("U0")),
    k_(constant::mathematical::twoPi/dict.get<scalar>("L")),
    nu_(dict.get<scalar>("nu")),
    origin_(dict.getOrDefault<point>("origin", Zero)),
    pRef_(dict.getOrDefault<scalar>("pRef", 0)),
    speed_(U0_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::exactFields::TaylorGreenExact::setTime(const scalar t)
{
    speed_ = U0_*std::exp(-2*nu_*sqr(k_)*t);
}


Foam::vector Foam::exactFields::TaylorGreenExact::U(const point& x) const
{
    const vector d(k_*(x - origin_));
    vector U(Zero);
    U[x_] = speed_*std::sin(d[x_])*std::cos(d[y_]);
    U[y_] = -speed_*std::cos(d[x_])*std::sin(d[y_]);
    return U;
}


Foam::scalar Foam::exactFields::TaylorGreenExact::p(const point& x) const
{
    const vector d(k_*(x - origin_));
    return
        pRef_
      + 0.25*rho0_*sqr(speed_)*(std::cos(2*d[x_]) + std::cos(2*d[y_]));
}


// ************************************************************************* //
