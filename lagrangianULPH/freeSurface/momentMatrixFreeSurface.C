/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentMatrixFreeSurface.H"
#include "addToRunTimeSelectionTable.H"
#include "momentTensor.H"
#include "inputChecks.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace freeSurfaces
{
    defineTypeNameAndDebug(momentMatrixFreeSurface, 0);
    addToRunTimeSelectionTable(freeSurface, momentMatrixFreeSurface, dictionary);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::freeSurfaces::momentMatrixFreeSurface::threshold
(
    const dictionary& dict,
    const word& name,
    const scalar fraction,
    const ulphCloud& cloud
) const
{
    const scalar hByDx = cloud.h()/cloud.dx();
    if (!dict.found(name) && (hByDx < 1.49 || hByDx > 2.51))
    {
        FatalIOErrorInFunction(entryPlace(dict.parent(), "hByDx"))
            << "No threshold of lambda is known for h/dx = " << hByDx
            << ", only for 1.5 to 2.5." << nl
            << "    Set hByDx to 2, or give freeSurface { type momentMatrix; "
            << "surface ...; interior ...; }" << nl
            << "    as fractions of the lattice value of lambda, "
            << cloud.shared().beta/sqr(cloud.dx()) << " here."
            << exit(FatalIOError);
    }
    return
        getInRange(dict, name, fraction, scalarMinMax(0, 1))
       *cloud.shared().beta/sqr(cloud.dx());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::freeSurfaces::momentMatrixFreeSurface::momentMatrixFreeSurface
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    D_(cloud.D()),
    h_(cloud.h()),
    dx_(cloud.dx()),
    surface_(threshold(dict, "surface", surfaceFraction, cloud)),
    interior_(threshold(dict, "interior", interiorFraction, cloud)),
    thin_(thinFraction*cloud.shared().beta/sqr(cloud.dx()))
{
    refuseMisspelt(dict, {"type", "surface", "interior"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::effectNeeds Foam::freeSurfaces::momentMatrixFreeSurface::needs() const
{
    effectNeeds all;
    all.fields.set("lambda", 1);
    all.fields.set("surface", 1);
    all.fields.set("normal", D_);
    all.geometry = ulph::momentSums;
    return all;
}


void Foam::freeSurfaces::momentMatrixFreeSurface::bind(ulphCloud& cloud)
{
    lambda_ = cloud.derived("lambda");
    class_ = cloud.derived("surface");
    normal_ = cloud.derived("normal");
}


void Foam::freeSurfaces::momentMatrixFreeSurface::eigenvalue
(
    const ulph::geometryBlock& sums,
    ulph::laneRow& lambda
) const
{
    momentTensor::smallestEigenvalue(D_, sums.count, sums.M, lambda);
    ulph::forLanes(sums.count, [&](const int l) { lambda[l] /= sqr(dx_); });
}


void Foam::freeSurfaces::momentMatrixFreeSurface::release
(
    const label first,
    const label count,
    double* densityExcess
) const
{
    ulph::laneRow classes;
    ulph::laneRow lambda;
    class_->load(0, first, count, classes);
    lambda_->load(0, first, count, lambda);

    label nReleased = 0;
    label nThin = 0;
    for (label l = 0; l < count; ++l)
    {
        if (classes[l] == splash && densityExcess[l] != 0)
        {
            densityExcess[l] = 0;
            ++nReleased;
        }
        if
        (
            classes[l] == surface && lambda[l] < thin_
         && densityExcess[l] < 0
        )
        {
            densityExcess[l] = 0;
            ++nThin;
        }
    }
    if (nReleased)
    {
        #pragma omp atomic
        nReleased_ += nReleased;
    }
    if (nThin)
    {
        #pragma omp atomic
        nThin_ += nThin;
    }
}


void Foam::freeSurfaces::momentMatrixFreeSurface::keepInside
(
    const label first,
    const label count,
    ulph::laneRow& values
) const
{
    ulph::laneRow surface;
    class_->load(0, first, count, surface);
    ulph::forLanes(count, [&](const int l)
    {
        values[l] = surface[l] == interior ? values[l] : 0;
    });
}


void Foam::freeSurfaces::momentMatrixFreeSurface::report(Ostream& os) const
{
    os  << "    freeSurface: pressure of a splash particle set to zero "
        << returnReduce(nReleased_, sumOp<label>()) << " times" << nl
        << "    freeSurface: tension of a particle of a thin film or drop set to zero "
        << returnReduce(nThin_, sumOp<label>()) << " times" << nl;
}


// ************************************************************************* //
