/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleLattice.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(particleLattice, 0);
    defineRunTimeSelectionTable(particleLattice, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleLattice::particleLattice
(
    const wallSearch& search,
    const scalar dx
)
:
    search_(search),
    dx_(dx)
{}


// ************************************************************************* //
