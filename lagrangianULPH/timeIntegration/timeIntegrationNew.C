/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeIntegration.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(timeIntegration, 0);
    defineRunTimeSelectionTable(timeIntegration, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::timeIntegration> Foam::timeIntegration::New
(
    const dictionary& dict,
    const ulphCloud& cloud
)
{
    return selectModel<timeIntegration>(dict, typeName, cloud);
}


// ************************************************************************* //
