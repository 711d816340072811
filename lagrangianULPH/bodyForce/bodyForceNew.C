/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyForce.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(bodyForce, 0);
    defineRunTimeSelectionTable(bodyForce, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::bodyForce> Foam::bodyForce::New
(
    const dictionary& dict,
    const ulphCloud& cloud
)
{
    return selectModel<bodyForce>(dict, typeName, cloud);
}


// ************************************************************************* //
