/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noBodyForce.H"
#include "addToRunTimeSelectionTable.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace bodyForces
{
    defineTypeNameAndDebug(noBodyForce, 0);
    addToRunTimeSelectionTable(bodyForce, noBodyForce, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyForces::noBodyForce::noBodyForce(const dictionary&, const ulphCloud&)
{}


// ************************************************************************* //
