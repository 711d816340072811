/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gravityForce.H"
#include "addToRunTimeSelectionTable.H"
#include "gravityMeshObject.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace bodyForces
{
    defineTypeNameAndDebug(gravityForce, 0);
    addToRunTimeSelectionTable(bodyForce, gravityForce, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyForces::gravityForce::gravityForce(const dictionary&, const ulphCloud& cloud)
:
    g_(meshObjects::gravity::New(cloud.mesh().time()).value())
{}


// ************************************************************************* //
