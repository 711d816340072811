/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Checks that unusable input is refused with the reason.

\*---------------------------------------------------------------------------*/

#include "checks.H"
#include "fluidLattice.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

void refused
(
    tally& t,
    const testCase& c,
    const std::string& name,
    const std::string& content,
    const std::string& reason
)
{
    std::string message("no error");

    try
    {
        const dictionary dict(parse(content));
        fluidLattice fluid(c.mesh, c.search, dict);
    }
    catch (const Foam::error& err)
    {
        message = err.message();
    }

    const bool found = message.find(reason) != std::string::npos;

    t.check
    (
        found,
        "refused: " + name + (found ? "" : ", but says: " + message)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::inputChecks(tally& t)
{
    testCase c("box2D");

    FatalError.throwExceptions();
    FatalIOError.throwExceptions();

    const std::string box("source boxToPoint; box (0 0 -1) (0.5 0.5 1); ");
    const std::string good("regions { a { " + box + "} }");

    refused(t, c, "dx missing", good, "dx [m] is missing");
    refused(t, c, "dx negative", "dx -0.1; " + good, "above zero");
    refused(t, c, "dx above the mesh", "dx 3; " + good, "larger than the mesh");
    refused(t, c, "no regions", "dx 0.01;", "regions");
    refused(t, c, "empty regions", "dx 0.01; regions {}", "no region to fill");
    refused
    (
        t, c, "region that is no dictionary", "dx 0.01; regions { a 1; }",
        "is no dictionary"
    );
    refused
    (
        t, c, "region without source", "dx 0.01; regions { a {} }",
        "needs either the entry"
    );
    refused
    (
        t, c, "unknown source",
        "dx 0.01; regions { a { source boxToPint; } }",
        "Unknown source boxToPint"
    );
    refused
    (
        t, c, "source that goes by labels of the mesh",
        "dx 0.01; regions { a { source labelToPoint; value (1 2); } }",
        "Unknown source labelToPoint"
    );
    refused
    (
        t, c, "missing field",
        "dx 0.01; regions { a { field alpha.oil; } }",
        "There is no volScalarField"
    );
    refused
    (
        t, c, "region smaller than dx",
        "dx 0.01; regions { a { source boxToPoint;"
        " box (0.1 0.1 -1) (0.104 0.104 1); } }",
        "Region a gets 0 particles"
    );
    refused
    (
        t, c, "region outside the mesh",
        "dx 0.01; regions { a { source boxToPoint;"
        " box (5 5 -1) (6 6 1); } }",
        "Region a gets 0 particles"
    );
    refused
    (
        t, c, "region off the mid-plane",
        "dx 0.01; regions { a { source boxToPoint;"
        " box (0 0 -1) (0.5 0.5 0); } }",
        "mid-plane"
    );
    refused
    (
        t, c, "overlapping regions",
        "dx 0.01; regions { a { " + box + "} b { source boxToPoint;"
        " box (0.4 0.4 -1) (0.8 0.8 1); } }",
        "Regions a and b overlap at"
    );
    refused
    (
        t, c, "unknown lattice",
        "dx 0.01; regions { a { " + box + "lattice { type cubic; } } }",
        "Unknown particleLattice type cubic"
    );
    refused
    (
        t, c, "unknown initial field",
        "dx 0.01; regions { a { " + box + "pressure { type still; } } }",
        "Unknown initialField type still"
    );
    refused
    (
        t, c, "hydrostatic pressure without gravity",
        "dx 0.01; regions { a { " + box
      + "pressure { type hydrostatic; } } }",
        "there is no file"
    );

    FatalError.dontThrowExceptions();
    FatalIOError.dontThrowExceptions();
}


// ************************************************************************* //
