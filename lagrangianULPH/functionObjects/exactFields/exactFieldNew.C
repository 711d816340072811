/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactField.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(exactField, 0);
    defineRunTimeSelectionTable(exactField, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::exactField> Foam::exactField::New
(
    const dictionary& dict,
    const ulphCloud& cloud
)
{
    return selectModel<exactField>(dict, "exact", cloud);
}


// ************************************************************************* //
