/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "pointGrid.H"
#include "StringStream.H"
#include "mathematicalConstants.H"
#include <cmath>
#include <random>
#include <sstream>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::tally::check(const bool passed, const std::string& line)
{
    (passed ? nPassed : nFailed) += 1;

    Info<< (passed ? "PASS  " : "FAIL  ") << line.c_str() << endl;
}


Foam::testCase::testCase(const fileName& name)
:
    time(Time::controlDictName, cwd(), name),
    mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            time.timeName(),
            time,
            IOobject::MUST_READ
        )
    ),
    search(mesh)
{}


Foam::wallParticleSet Foam::testCase::allWalls(const scalar dx) const
{
    wallParticles walls(search, dx);
    walls.update([](const boundBox&) { return true; });

    return walls.active();
}


Foam::pointField Foam::testCase::randomPoints
(
    const label n,
    const scalar margin
) const
{
    std::mt19937 generator(1);
    std::uniform_real_distribution<scalar> uniform(0, 1);

    const vector span(mesh.bounds().span() + vector::uniform(2*margin));
    pointField points(n);

    for (point& p : points)
    {
        for (direction d = 0; d < 3; ++d)
        {
            p[d] =
                mesh.bounds().min()[d] - margin + uniform(generator)*span[d];
        }

        p = search.onMidPlane(p);
    }

    return points;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::parse(const std::string& content)
{
    IStringStream stream(content);

    return dictionary(stream);
}


std::string Foam::text(const scalar x)
{
    std::ostringstream stream;
    stream.precision(6);
    stream << x;

    return stream.str();
}


Foam::scalar Foam::kernel
(
    const scalar r,
    const scalar dx,
    const label nDims
)
{
    using constant::mathematical::pi;

    const scalar h = 2*dx;
    const scalar q = r/h;

    if (q >= 2) return 0;

    const scalar scale =
        nDims == 2 ? 7/(4*pi*sqr(h)) : 21/(16*pi*pow3(h));

    return scale*pow4(1 - 0.5*q)*(1 + 2*q);
}


Foam::scalar Foam::smallestGap(const UList<point>& points, const scalar dx)
{
    pointGrid grid(1.5*dx);
    scalar gapSqr = GREAT;

    for (const point& p : points)
    {
        grid.near
        (
            p,
            [&](label, const scalar dSqr)
            {
                gapSqr = min(gapSqr, dSqr);
                return true;
            }
        );
        grid.append(p);
    }

    return std::sqrt(gapSqr);
}


// ************************************************************************* //
