/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gravityForce.H"
#include "addToRunTimeSelectionTable.H"
#include "uniformDimensionedFields.H"

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
    g_
    (
        uniformDimensionedVectorField
        (
            IOobject
            (
                "g",
                cloud.mesh().time().constant(),
                cloud.mesh().time(),
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        ).value()
    )
{}


// ************************************************************************* //
