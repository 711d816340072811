/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    Test-geometry

Description
    Checks of the fluid lattice, initial fields, wall particles, wall search
    and cell location on small meshes. Runs in the folder that holds the
    meshed cases; prints one line per check and returns 1 when one fails.

\*---------------------------------------------------------------------------*/

#include "checks.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main()
{
    using namespace Foam;

    tally t;

    fluidChecks(t);
    packedChecks(t);
    initialChecks(t);
    wallChecks(t);
    curvedChecks(t);
    searchChecks(t);
    inputChecks(t);

    Info<< t.nPassed << " passed, " << t.nFailed << " failed" << endl;

    return t.nFailed ? 1 : 0;
}


// ************************************************************************* //
