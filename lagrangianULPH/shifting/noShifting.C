/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noShifting.H"
#include "addToRunTimeSelectionTable.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace shiftings
{
    defineTypeNameAndDebug(noShifting, 0);
    addToRunTimeSelectionTable(shifting, noShifting, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::shiftings::noShifting::noShifting(const dictionary&, const ulphCloud& cloud)
:
    shifting(0, cloud)
{}


// ************************************************************************* //
