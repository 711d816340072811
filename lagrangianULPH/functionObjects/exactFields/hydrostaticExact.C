/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hydrostaticExact.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "gravityForce.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace exactFields
{
    defineTypeNameAndDebug(hydrostaticExact, 0);
    addToRunTimeSelectionTable(exactField, hydrostaticExact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactFields::hydrostaticExact::hydrostaticExact
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    rho0_(cloud.rho0()),
    g_(bodyForces::gravityForce(dict, cloud).at(0).constant),
    level_(dict.get<scalar>("level")),
    pRef_(dict.getOrDefault<scalar>("pRef", 0))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::exactFields::hydrostaticExact::setTime(const scalar)
{}


Foam::vector Foam::exactFields::hydrostaticExact::U(const point&) const
{
    return Zero;
}


Foam::scalar Foam::exactFields::hydrostaticExact::p(const point& x) const
{
    return pRef_ + rho0_*max((g_ & x) + mag(g_)*level_, scalar(0));
}


// ************************************************************************* //
