/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wall.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(wall, 0);
    defineRunTimeSelectionTable(wall, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::wall> Foam::wall::New
(
    const dictionary& dict,
    const ulphCloud& cloud,
    const viscosity& viscous
)
{
    return selectModel<wall>(dict, typeName, cloud, viscous);
}


// ************************************************************************* //
