/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "slipWall.H"
#include "addToRunTimeSelectionTable.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace walls
{
    defineTypeNameAndDebug(slipWall, 0);
    addToRunTimeSelectionTable(wall, slipWall, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::walls::slipWall::slipWall
(
    const dictionary&,
    const ulphCloud& cloud,
    const viscosity&
)
:
    D_(cloud.D())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::walls::slipWall::viscousVelocity
(
    const label count,
    const ulph::laneRow*,
    const ulph::laneRow* reflected,
    ulph::laneRow* v
) const
{
    for (int k = 0; k < D_; ++k)
    {
        for (label l = 0; l < count; ++l)
        {
            v[k][l] = reflected[k][l];
        }
    }
}


// ************************************************************************* //
