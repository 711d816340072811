/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viscosity.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(viscosity, 0);
    defineRunTimeSelectionTable(viscosity, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::viscosity> Foam::viscosity::New
(
    const dictionary& dict,
    const ulphCloud& cloud
)
{
    return selectModel<viscosity>(dict, typeName, cloud);
}


// ************************************************************************* //
