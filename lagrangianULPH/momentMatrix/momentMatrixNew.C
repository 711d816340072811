/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentMatrix.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(momentMatrix, 0);
    defineRunTimeSelectionTable(momentMatrix, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::momentMatrix> Foam::momentMatrix::New
(
    const dictionary& dict,
    const ulphCloud& cloud
)
{
    return selectModel<momentMatrix>(dict, typeName, cloud);
}


// ************************************************************************* //
