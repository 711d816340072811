/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "centralForce.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace bodyForces
{
    defineTypeNameAndDebug(centralForce, 0);
    addToRunTimeSelectionTable(bodyForce, centralForce, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyForces::centralForce::centralForce
(
    const dictionary& dict,
    const ulphCloud&
)
:
    Psi_(dict.get<scalar>("Psi")),
    centre_(dict.getOrDefault<point>("centre", Zero))
{
    refuseMisspelt(dict, {"type", "Psi", "centre"});
}


// ************************************************************************* //
