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
        cloud,
        "kernelGradient",
        cloud.h()/cloud.shared().beta
    )
{
    refuseMisspelt(dict, {"type", "C"});
}


// ************************************************************************* //
