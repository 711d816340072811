/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Checks of wallParticles behind bent walls and where walls do not fit the
    particle spacing: the wall's part of the kernel sum against its integral.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "pointGrid.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Integral of the kernel over the space outside the mesh
scalar outsideIntegral
(
    const testCase& c,
    const point& p,
    const scalar dx,
    const label nPerDx
)
{
    const label nDims = c.search.nDims();
    const Vector<label>& geometricD = c.mesh.geometricD();
    const label n = 4*nPerDx;
    const scalar step = dx/nPerDx;
    scalar sum = 0;

    for (label i = -n; i < n; ++i)
    for (label j = -n; j < n; ++j)
    for (label k = -n; k < n; ++k)
    {
        if
        (
            (geometricD[0] < 0 && i) || (geometricD[1] < 0 && j)
         || (geometricD[2] < 0 && k)
        )
        {
            continue;
        }

        const point q
        (
            c.search.onMidPlane(p + step*vector(i + 0.5, j + 0.5, k + 0.5))
        );
        const scalar w = kernel(mag(q - p), dx, nDims);

        if (w > 0 && !c.search.contains(q))
        {
            sum += w*std::pow(step, nDims);
        }
    }

    return sum;
}


void checkPart
(
    tally& t,
    const word& name,
    const scalar dx,
    const label nPerDx,
    const scalar bound
)
{
    testCase c(name);
    const label nDims = c.search.nDims();
    const wallParticleSet walls(c.allWalls(dx));

    pointGrid grid(4*dx);
    for (const point& p : walls.position) grid.append(p);

    scalar worst = 0, meanSqr = 0, mean = 0;
    label n = 0;

    for (const point& p : c.randomPoints(40000, 0))
    {
        const scalar distance = c.search.signedDistance(p);

        if (distance < 0.5*dx || distance > 3*dx || n == 150) continue;

        scalar sum = 0;
        grid.near
        (
            p,
            [&](const label i, const scalar dSqr)
            {
                sum += walls.volume[i]*kernel(std::sqrt(dSqr), dx, nDims);
                return true;
            }
        );

        const scalar error = sum - outsideIntegral(c, p, dx, nPerDx);
        worst = max(worst, mag(error));
        mean += error;
        meanSqr += sqr(error);
        ++n;
    }

    t.check
    (
        n > 100 && worst < bound,
        name + ", dx " + text(dx) + ": wall's part of the kernel sum, error"
      + " at most " + text(worst) + ", rms " + text(std::sqrt(meanSqr/n))
      + ", mean " + text(mean/n)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::curvedChecks(tally& t)
{
    // What rows that fit the walls reach sets the scale
    checkPart(t, "box2D", 0.01, 8, 0.035);
    checkPart(t, "box3D", 0.02, 4, 0.06);

    checkPart(t, "turned2D", 0.0137, 8, 0.035);
    checkPart(t, "step2D", 0.0137, 8, 0.035);
    checkPart(t, "wedge2D", 0.01, 8, 0.035);
    checkPart(t, "wedge2D", 0.0173, 8, 0.035);
    checkPart(t, "cylinder2D", 0.01, 8, 0.035);
    checkPart(t, "cylinder2D", 0.05, 8, 0.035);
    checkPart(t, "box3D", 0.021, 4, 0.06);
    checkPart(t, "sphere3D", 0.02, 4, 0.06);
    checkPart(t, "sphere3D", 0.03, 4, 0.06);
}


// ************************************************************************* //
