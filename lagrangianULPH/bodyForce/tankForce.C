/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tankForce.H"
#include "addToRunTimeSelectionTable.H"
#include "gravityForce.H"
#include "ulphCloud.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace bodyForces
{
    defineTypeNameAndDebug(tankForce, 0);
    addToRunTimeSelectionTable(bodyForce, tankForce, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bodyForces::tankForce::tankForce
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    motion_(dict, cloud.mesh(), true)
{
    if (dict.getOrDefault("gravity", true))
    {
        gravity_.reset(new gravityForce(dict, cloud));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::linearMap Foam::bodyForces::tankForce::withGravity
(
    linearMap f,
    const scalar t
) const
{
    if (gravity_)
    {
        f.constant += motion_.rotation(t).T() & gravity_->at(t).constant;
    }
    return f;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::linearMap Foam::bodyForces::tankForce::at(const scalar t) const
{
    return withGravity(motion_.inertia(t), t);
}


Foam::linearMap Foam::bodyForces::tankForce::mean
(
    const scalar first,
    const scalar last
) const
{
    return withGravity(motion_.meanInertia(first, last), 0.5*(first + last));
}


// ************************************************************************* //
