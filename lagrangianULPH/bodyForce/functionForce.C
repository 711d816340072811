/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "functionForce.H"
#include "addToRunTimeSelectionTable.H"
#include "gravityForce.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace bodyForces
{
    defineTypeNameAndDebug(functionForce, 0);
    addToRunTimeSelectionTable(bodyForce, functionForce, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyForces::functionForce::functionForce
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    acceleration_(Foam::Function1<vector>::New("acceleration", dict))
{
    if (dict.getOrDefault("gravity", true))
    {
        gravity_.reset(new gravityForce(dict, cloud));
    }
}


// ************************************************************************* //
