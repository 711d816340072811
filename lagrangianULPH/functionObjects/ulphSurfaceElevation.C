/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphSurfaceElevation.H"
#include "addToRunTimeSelectionTable.H"
#include "gravityMeshObject.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(ulphSurfaceElevation, 0);
    addToRunTimeSelectionTable
    (
        functionObject, ulphSurfaceElevation, dictionary
    );
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField
Foam::functionObjects::ulphSurfaceElevation::filling(const point& gauge) const
{
    const ulphCloud& cloud = particles();
    scalarField sums(nSamples_, Zero);

    forParticles(gauge, [&](const label i, const vector& d)
    {
        const scalar height = ((d + gauge) & up_) - foot_;
        const scalar aside2 = magSqr(d) - sqr(d & up_);
        if (aside2 >= sqr(reach()))
        {
            return;
        }
        const scalar along = std::sqrt(sqr(reach()) - aside2);
        const label first = max(label(0), label(ceil((height - along)/step_)));
        const label last =
            min(nSamples_ - 1, label(floor((height + along)/step_)));
        const scalar V =
            cloud.mass()(i)/(cloud.rho0() + cloud.densityExcess()(i));
        for (label s = first; s <= last; ++s)
        {
            const scalar r2 = aside2 + sqr(s*step_ - height);
            sums[s] += V*weight(std::sqrt(max(r2, 0.0)));
        }
    });
    reduce(sums, sumOp<scalarField>());
    return sums;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalarList
Foam::functionObjects::ulphSurfaceElevation::valuesAt(const point& gauge) const
{
    scalarList found(3, Zero);
    found[0] = found[1] = foot_;

    const scalarField sums(filling(gauge));
    for (label s = 1; s < nSamples_; ++s)
    {
        if (sums[s - 1] >= 0.5 && sums[s] < 0.5)
        {
            const scalar part = (sums[s - 1] - 0.5)/(sums[s - 1] - sums[s]);
            found[0] = foot_ + (s - 1 + part)*step_;
            found[1] = found[2] > 0 ? found[1] : found[0];
            ++found[2];
        }
    }
    return found;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::ulphSurfaceElevation::ulphSurfaceElevation
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    ulphPointSamples(name, runTime, dict, typeName)
{
    read(dict);
    start();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::ulphSurfaceElevation::read(const dictionary& dict)
{
    const ulphCloud& cloud = particles();

    readPoints(dict, "gauges");
    if (!dict.readIfPresent("up", up_))
    {
        up_ = -meshObjects::gravity::New(time_).value();
    }
    up_ = unitDirection(dict, "up", up_);

    // From corner to corner of the mesh, and what the kernel reaches past it
    scalar lower = GREAT;
    scalar upper = -GREAT;
    const pointField corners(mesh_.bounds().points());
    for (const point& corner : corners)
    {
        lower = min(lower, corner & up_);
        upper = max(upper, corner & up_);
    }
    foot_ = lower - reach();
    step_ = 0.25*cloud.dx();
    nSamples_ = label((upper + reach() - foot_)/step_) + 2;

    return ulphFunctionObject::read(dict);
}


// ************************************************************************* //
