/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "artificialViscosity.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace viscosities
{
    defineTypeNameAndDebug(artificialViscosity, 0);
    addToRunTimeSelectionTable(viscosity, artificialViscosity, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosities::artificialViscosity::artificialViscosity
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    mu_
    (
        getInRange(dict, "alpha", scalarMinMax::ge(0))
       *cloud.h()*cloud.c0()*cloud.rho0()
    ),
    symmetric_(dict.getOrDefault("symmetric", true))
{
    refuseMisspelt(dict, {"type", "alpha", "symmetric"});
}


// ************************************************************************* //
