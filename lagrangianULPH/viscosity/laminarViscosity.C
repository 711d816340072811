/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "laminarViscosity.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace viscosities
{
    defineTypeNameAndDebug(laminarViscosity, 0);
    addToRunTimeSelectionTable(viscosity, laminarViscosity, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosities::laminarViscosity::laminarViscosity
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    mu_
    (
        getInRange(dict, "nu", scalarMinMax::ge(0))
       *2*(cloud.D() + 2)*cloud.rho0()
    ),
    symmetric_(dict.getOrDefault("symmetric", true))
{
    refuseMisspelt(dict, {"type", "nu", "symmetric"});
}


// ************************************************************************* //
