/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "freeSurface.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(freeSurface, 0);
    defineRunTimeSelectionTable(freeSurface, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::freeSurface> Foam::freeSurface::New
(
    const dictionary& dict,
    const ulphCloud& cloud
)
{
    return selectModel<freeSurface>(dict, typeName, cloud);
}


// ************************************************************************* //
