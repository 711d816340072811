/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fullMomentMatrix.H"
#include "addToRunTimeSelectionTable.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace momentMatrices
{
    defineTypeNameAndDebug(fullMomentMatrix, 0);
    addToRunTimeSelectionTable(momentMatrix, fullMomentMatrix, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentMatrices::fullMomentMatrix::fullMomentMatrix(const dictionary&, const ulphCloud& cloud)
:
    momentMatrix(cloud)
{}


// ************************************************************************* //
