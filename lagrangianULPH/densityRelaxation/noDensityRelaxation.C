/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noDensityRelaxation.H"
#include "addToRunTimeSelectionTable.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace densityRelaxations
{
    defineTypeNameAndDebug(noDensityRelaxation, 0);
    addToRunTimeSelectionTable(densityRelaxation, noDensityRelaxation, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::densityRelaxations::noDensityRelaxation::noDensityRelaxation(const dictionary&, const ulphCloud&)
{}


// ************************************************************************* //
