/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noFreeSurface.H"
#include "addToRunTimeSelectionTable.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace freeSurfaces
{
    defineTypeNameAndDebug(noFreeSurface, 0);
    addToRunTimeSelectionTable(freeSurface, noFreeSurface, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::freeSurfaces::noFreeSurface::noFreeSurface(const dictionary&, const ulphCloud&)
{}


// ************************************************************************* //
