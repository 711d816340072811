/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "densityRelaxation.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(densityRelaxation, 0);
    defineRunTimeSelectionTable(densityRelaxation, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::densityRelaxation> Foam::densityRelaxation::New
(
    const dictionary& dict,
    const ulphCloud& cloud
)
{
    return selectModel<densityRelaxation>(dict, typeName, cloud);
}


// ************************************************************************* //
