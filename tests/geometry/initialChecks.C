/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Checks of initialField.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "initialField.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Largest error of a field against the exact values
template<class Type>
scalar errorOf
(
    const std::string& entries,
    const initialRegion& region,
    const std::function<Type(const point&)>& exact
)
{
    const dictionary dict(parse(entries));
    const Field<Type> values
    (
        initialField<Type>::New("f", dict, region)->value(region.positions)
    );

    scalar error = 0;
    forAll(values, i)
    {
        error = max(error, mag(values[i] - exact(region.positions[i])));
    }

    return error;
}


//- Pressure at a point of a rectangle of sides 2 and 1 about (1 1 0)
scalar rectanglePressure(const testCase& c, const point& p)
{
    const pointField points(1, p);
    const dictionary dict
    (
        parse
        (
            "rho0 1000; f { type rotatingRectangle; omega 3; sides (2 1);"
            " centre (1 1 0); }"
        )
    );
    return initialField<scalar>::New
    (
        "f", dict, initialRegion{c.time, points, 0.02}
    )->value(points)()[0];
}


//- The pressure is zero on the sides, and its Laplacian that of a rotation
void rectangleChecks(tally& t, const testCase& c)
{
    const scalar source = 2*1000*sqr(3.0);

    scalar sides = 0;
    for (const scalar s : {-0.4, 0.1, 0.45})
    {
        for
        (
            const point& p :
            {
                point(1 + 2*s, 0.5, 0), point(1 + 2*s, 1.5, 0),
                point(0, 1 + s, 0), point(2, 1 + s, 0)
            }
        )
        {
            sides = max(sides, mag(rectanglePressure(c, p)));
        }
    }
    t.check
    (
        sides < 1e-5*source,
        "initial field rotatingRectangle: on the sides " + text(sides)
    );

    const scalar d = 0.02;
    const point p(1.3, 0.8, 0);
    const scalar laplacian =
    (
        rectanglePressure(c, p + vector(d, 0, 0))
      + rectanglePressure(c, p - vector(d, 0, 0))
      + rectanglePressure(c, p + vector(0, d, 0))
      + rectanglePressure(c, p - vector(0, d, 0))
      - 4*rectanglePressure(c, p)
    )/sqr(d);
    t.check
    (
        mag(laplacian/source - 1) < 1e-3,
        "initial field rotatingRectangle: Laplacian over 2 rho omega^2 "
      + text(laplacian/source)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::initialChecks(tally& t)
{
    testCase c("box3D");
    const pointField points(c.randomPoints(100, 0));
    const initialRegion region{c.time, points, 0.02};

    const auto report = [&](const scalar error, const std::string& name)
    {
        t.check
        (
            error < 1e-9,
            "initial field " + name + ": error " + text(error)
        );
    };

    report
    (
        errorOf<vector>("", region, [](const point&) { return vector(Zero); }),
        "absent"
    );
    report
    (
        errorOf<scalar>("f 3;", region, [](const point&) { return 3; }),
        "as a value"
    );
    report
    (
        errorOf<vector>
        (
            "f uniform (1 2 3);",
            region,
            [](const point&) { return vector(1, 2, 3); }
        ),
        "as a uniform value"
    );
    report
    (
        errorOf<vector>
        (
            "f { type linear; value (1 0 0); origin (0 1 0);"
            " gradient (0 0 5  2 0 0  0 0 0); }",
            region,
            [](const point& p)
            {
                return vector(1 + 2*(p.y() - 1), 0, 5*p.x());
            }
        ),
        "linear (vector)"
    );
    report
    (
        errorOf<scalar>
        (
            "f { type linear; gradient (1 2 3); }",
            region,
            [](const point& p) { return p & vector(1, 2, 3); }
        ),
        "linear (scalar)"
    );
    report
    (
        errorOf<scalar>
        (
            "f { type profile; direction (0 2 0); origin (0 0.1 0);"
            " value table ((-1 -3) (1 3)); }",
            region,
            [](const point& p) { return 3*(p.y() - 0.1); }
        ),
        "profile"
    );

    report
    (
        errorOf<scalar>
        (
            "f { type quadratic; value 5; origin (0 1 0); gradient (1 0 2);"
            " hessian (2 1 0 0 0 4); }",
            region,
            [](const point& p)
            {
                const scalar x = p.x(), y = p.y() - 1, z = p.z();
                return 5 + x + 2*z + sqr(x) + x*y + 2*sqr(z);
            }
        ),
        "quadratic"
    );
    rectangleChecks(t, c);

    // The file constant/g of this case is tilted
    const vector g(1, -2, 2);
    scalar highest = -GREAT;
    for (const point& p : points)
    {
        highest = max(highest, -(p & g)/3);
    }

    report
    (
        errorOf<scalar>
        (
            "rho0 1000; f { type hydrostatic; }",
            region,
            [&](const point& p)
            {
                return 1000*((p & g) + 3*(highest + 0.01));
            }
        ),
        "hydrostatic, tilted gravity"
    );
    report
    (
        errorOf<scalar>
        (
            "f { type hydrostatic; rho0 2; level 1; pRef 5; }",
            region,
            [&](const point& p) { return 5 + 2*((p & g) + 3); }
        ),
        "hydrostatic, given level"
    );

    if (isAdministrator())
    {
        Info<< "SKIP  initial field coded: root may not run it" << endl;
        return;
    }

    report
    (
        errorOf<vector>
        (
            "f { type coded; localCode #{ const scalar two = 2; #};"
            " code #{ return two*position + vector(0, 0, 1); #}; }",
            region,
            [](const point& p) { return 2*p + vector(0, 0, 1); }
        ),
        "coded"
    );
}


// ************************************************************************* //
