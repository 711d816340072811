/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shifting.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(shifting, 0);
    defineRunTimeSelectionTable(shifting, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::shifting> Foam::shifting::New
(
    const dictionary& dict,
    const ulphCloud& cloud
)
{
    return selectModel<shifting>(dict, typeName, cloud);
}


// ************************************************************************* //
