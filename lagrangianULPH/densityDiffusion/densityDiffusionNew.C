/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "densityDiffusion.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(densityDiffusion, 0);
    defineRunTimeSelectionTable(densityDiffusion, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::densityDiffusion> Foam::densityDiffusion::New
(
    const dictionary& dict,
    const ulphCloud& cloud
)
{
    return selectModel<densityDiffusion>(dict, typeName, cloud);
}


// ************************************************************************* //
