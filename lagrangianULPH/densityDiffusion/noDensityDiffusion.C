/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noDensityDiffusion.H"
#include "addToRunTimeSelectionTable.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace densityDiffusions
{
    defineTypeNameAndDebug(noDensityDiffusion, 0);
    addToRunTimeSelectionTable(densityDiffusion, noDensityDiffusion, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::densityDiffusions::noDensityDiffusion::noDensityDiffusion(const dictionary&, const ulphCloud&)
{}


// ************************************************************************* //
