/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scenes.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::string Foam::scene::properties(const bool mixed) const
{
    return
        "dx " + text(dx) + "; rho0 1000; c0 35; precision "
      + (mixed ? "mixed" : "double") + ";";
}


Foam::scene Foam::scene::ball(const int D)
{
    const double dx = D == 2 ? 0.02 : 0.05;
    return {D == 2 ? "square2D" : "cube3D", D, dx, fluidState::ball(D, dx)};
}


Foam::scene Foam::scene::tank(const int D)
{
    const double dx = D == 2 ? 0.025 : 0.04;
    const vec size(D == 2 ? vec(1, 0.8, 0) : vec(0.4, 0.32, 0.32));

    std::vector<vec> places;
    for (const vec& x : jitteredLattice(D, dx, vec::Zero(), size, 0.2))
    {
        const double depth = x[0] < 0.4*size[0] ? 0.7 : 0.4;
        if (x[D - 1] < depth*size[D - 1])
        {
            places.push_back(x);
        }
    }
    return
    {
        D == 2 ? "tank2D" : "tank3D",
        D,
        dx,
        fluidState::random(D, dx, places)
    };
}


std::vector<Foam::scene> Foam::scene::all()
{
    return {ball(2), ball(3), tank(2), tank(3)};
}


// ************************************************************************* //
