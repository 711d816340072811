/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hydrostaticInitialField.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

vector readGravity(const Time& time, const dictionary& dict)
{
    const IOobject io
    (
        "g",
        time.constant(),
        time,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    IOobject header(io);

    if (!header.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        FatalIOErrorInFunction(dict)
            << "A hydrostatic pressure needs gravity: there is no file "
            << io.objectPath() << nl
            << "    Add it (dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);)"
            << " or choose another pressure"
            << exit(FatalIOError);
    }

    const vector g(uniformDimensionedVectorField(io).value());

    if (mag(g) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Gravity in " << io.objectPath()
            << " is zero: nothing makes the pressure hydrostatic." << nl
            << "    Give a pressure of another type, such as uniform"
            << exit(FatalIOError);
    }

    return g;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::initialFields::hydrostatic::hydrostatic
(
    const dictionary& dict,
    const initialRegion& region
)
:
    g_(readGravity(region.time, dict)),
    rho0_(dict.get<scalar>("rho0", keyType::REGEX_RECURSIVE)),
    pRef_(dict.getOrDefault<scalar>("pRef", 0)),
    level_(-GREAT)
{
    const vector up(-g_/mag(g_));

    for (const point& p : region.positions)
    {
        level_ = max(level_, (p & up) + 0.5*region.dx);
    }

    dict.readIfPresent("level", level_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::initialFields::hydrostatic::value
(
    const UList<point>& positions
) const
{
    auto tvalues = tmp<scalarField>::New(positions.size());
    const scalar magG = mag(g_);

    forAll(positions, i)
    {
        const scalar depth = level_ + (positions[i] & g_)/magG;

        tvalues.ref()[i] = pRef_ + rho0_*magG*depth;
    }

    return tvalues;
}


// ************************************************************************* //
