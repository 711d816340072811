/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noViscosity.H"
#include "addToRunTimeSelectionTable.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace viscosities
{
    defineTypeNameAndDebug(noViscosity, 0);
    addToRunTimeSelectionTable(viscosity, noViscosity, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscosities::noViscosity::noViscosity(const dictionary&, const ulphCloud&)
{}


// ************************************************************************* //
