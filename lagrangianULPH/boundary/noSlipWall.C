/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noSlipWall.H"
#include "addToRunTimeSelectionTable.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace walls
{
    defineTypeNameAndDebug(noSlipWall, 0);
    addToRunTimeSelectionTable(wall, noSlipWall, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::walls::noSlipWall::noSlipWall
(
    const dictionary&,
    const ulphCloud& cloud,
    const viscosity&
)
:
    D_(cloud.D())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::walls::noSlipWall::viscousVelocity
(
    const label count,
    const ulph::laneRow* fluid,
    const ulph::laneRow*,
    ulph::laneRow* v
) const
{
    for (int k = 0; k < D_; ++k)
    {
        for (label l = 0; l < count; ++l)
        {
            v[k][l] = -fluid[k][l];
        }
    }
}


// ************************************************************************* //
