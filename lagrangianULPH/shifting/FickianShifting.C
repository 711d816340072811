/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "FickianShifting.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace shiftings
{
    defineTypeNameAndDebug(FickianShifting, 0);
    addToRunTimeSelectionTable(shifting, FickianShifting, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::shiftings::FickianShifting::FickianShifting
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    shifting
    (
        getInRange(dict, "C", 2, scalarMinMax::ge(0)),
        cloud
    ),
    scale_(cloud.h()/cloud.shared().beta)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::shiftings::FickianShifting::direction
(
    const ulph::geometryBlock& sums,
    ulph::laneRow* R
) const
{
    for (int k = 0; k < D_; ++k)
    {
        for (int l = 0; l < sums.count; ++l)
        {
            R[k][l] = scale_*sums.b[k][l];
        }
    }
}


// ************************************************************************* //
