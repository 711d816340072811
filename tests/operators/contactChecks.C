/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Checks of wallContact where walls meet.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "scenes.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A particle in contact with all walls of a corner keeps no velocity into any
static void cornerChecks(tally& t, const int D)
{
    const scene where(scene::tank(D));
    const testCase room(where.name);
    rig library(room, where.properties(false), where.state);

    ulphCloud& cloud = library.cloud;
    for (int k = 0; k < D; ++k)
    {
        cloud.x().component(k)[0] = (0.1 + 0.02*k)*where.dx;
        cloud.v().component(k)[0] = -1;
    }
    library.rates.updateNeighbours(0);
    library.contact.limitVelocity(0, 0, linearMap());

    scalar fastest = GREAT;
    for (label i = 0; i < cloud.size(); ++i)
    {
        if (cloud.origId()[i] == 0)
        {
            fastest = 0;
            for (int k = 0; k < D; ++k)
            {
                fastest = max(fastest, -cloud.v()(i, k));
            }
        }
    }
    t.check
    (
        where.name + " corner: velocity into a wall", fastest, 1e-12
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::contactChecks(tally& t)
{
    for (const int D : {2, 3})
    {
        cornerChecks(t, D);
    }
}


// ************************************************************************* //
