/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Neighbour lists while particles move: kept, renewed in part or built anew, the
    right-hand side is that of the printed equations.

\*---------------------------------------------------------------------------*/

#include "modelChoices.H"
#include "scenes.H"

#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Move every particle; the displacement is a function of its number
static void move(rig& library, const std::function<vec(int)>& displacement)
{
    for (int i = 0; i < library.size(); ++i)
    {
        const vec d(displacement(library.cloud.origId()[i]));
        for (int k = 0; k < library.cloud.D(); ++k)
        {
            library.cloud.x().component(k)[i] += d[k];
        }
    }
}


//- The lists hold as long as no two particles move by the skin relative to each
//- other, and no longer
static void skinChecks(tally& t, const scene& where)
{
    const testCase room(where.name);
    const modelChoice& choice = choices[0];
    rig library(room, where.properties(false) + choice.properties, where.state);
    library.evaluate();
    const scalar skin = 0.2*where.dx;

    vec along(vec::Zero());
    along.head(where.D).setConstant(1/std::sqrt(scalar(where.D)));
    for (const int nBuilds : {1, 2})
    {
        // To 0.98, then to 1.1 of the skin, odd against even numbers
        const vec step
        (
            (nBuilds == 1 ? 0.49 : 0.06)*skin*along
        );
        move
        (
            library, [&](int number) { return number % 2 ? step : vec(-step); }
        );
        library.evaluate();

        const std::string what
        (
            where.name + " moved, list " + std::to_string(nBuilds)
        );
        t.check(what + " is in use", library.neighbours.nBuilds() == nBuilds);
        compare(t, what, library, choice.printed, 1e-12);
    }
}


//- Balls about centres, and the number of particles of each
static std::pair<scene, int> balls(const int D, const std::vector<vec>& centres)
{
    scene where(scene::ball(D));
    const int n = where.state.size();
    std::vector<vec> places;
    for (const vec& centre : centres)
    {
        for (const vec& x : where.state.x)
        {
            places.push_back(x + centre);
        }
    }
    where.state = fluidState::random(D, where.dx, places);
    return {where, n};
}


//- Two balls that move past each other keep their lists; stirred, they do not
static void partChecks(tally& t, const int D)
{
    const double offset = D == 2 ? 0.4 : 0.6;
    const auto [where, size] = balls(D, {vec(-offset, 0, 0), vec(offset, 0, 0)});
    const int n = size;
    const testCase room(where.name);
    const modelChoice& choice = choices[0];
    rig library(room, where.properties(false) + choice.properties, where.state);
    library.evaluate();

    const std::string what(where.name + " two balls ");
    const vec step(0, 0.2*where.dx, 0);
    move
    (
        library,
        [&](const int number) { return vec((number < n ? 0.8 : -0.8)*step); }
    );
    library.evaluate();
    t.check(what + "keep their lists", library.neighbours.nBuilds() == 1);
    compare(t, what + "apart", library, choice.printed, 1e-12);

    move
    (
        library,
        [&](const int number) { return vec((number % 2 ? 0.55 : -0.55)*step); }
    );
    library.evaluate();
    t.check(what + "stirred get new lists", library.neighbours.nBuilds() == 2);
    compare(t, what + "stirred", library, choice.printed, 1e-12);
}


//- Where a part of the fluid is stirred, its lists are renewed and the others kept
static void renewalChecks
(
    tally& t,
    const scene& where,
    const std::function<bool(int)>& isStirred
)
{
    const testCase room(where.name);
    const modelChoice& choice = choices[0];
    rig library(room, where.properties(false) + choice.properties, where.state);
    library.evaluate();

    // Past the skin of a build, short of that of a renewal, and past it
    const scalar ways[] = {1.1*0.2*where.dx, 1.8*0.2*where.dx, 0.6*0.2*where.dx};
    for (int i = 0; i < 3; ++i)
    {
        const vec step(0, 0.5*ways[i], 0);
        move
        (
            library,
            [&](const int number)
            {
                return vec((isStirred(number) ? 1 : 0)*(number % 2 ? 1 : -1)*step);
            }
        );
        library.evaluate();
        const std::string what
        (
            where.name + " stirred in part, " + std::to_string(i + 1)
        );
        t.check(what + ": no build", library.neighbours.nBuilds() == 1);
        t.check
        (
            what + ": renewals",
            library.neighbours.nRenewals() >= (i < 2 ? 1 : 2)
         && library.neighbours.nRenewals() <= i + 1
        );
        const std::size_t nNew = library.neighbours.newLists().size();
        t.check
        (
            what + ": some lists are new",
            i == 1
         || (nNew > 0 && label(nNew) < library.neighbours.fluidList().size())
        );
        compare(t, what, library, choice.printed, 1e-12);
    }
}


//- A drop that falls as a whole finds the floor in time
static void fallChecks(tally& t)
{
    scene where(scene::tank(2));
    where.state = fluidState::ball(2, where.dx);
    for (vec& x : where.state.x)
    {
        x += vec(0.5, 0.45, 0);
    }

    const testCase room(where.name);
    const modelChoice& choice = choices[0];
    rig library(room, where.properties(false) + choice.properties, where.state);
    library.evaluate();
    t.check(where.name + " drop in the air", library.wall.size() == 0);

    for (int i = 0; i < 30; ++i)
    {
        move(library, [&](int) { return vec(0, -0.25*where.dx, 0); });
        library.rates.updateNeighbours(0);
    }
    library.evaluate();
    t.check(where.name + " fallen drop meets walls", library.wall.size() > 0);
    compare(t, where.name + " fallen drop", library, choice.printed, 1e-12);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::neighbourChecks(tally& t)
{
    for (const scene& where : scene::all())
    {
        skinChecks(t, where);
    }
    for (const int D : {2, 3})
    {
        partChecks(t, D);
        // Two cells and more apart
        std::vector<vec> centres;
        for (int i = 0; i < (D == 2 ? 6 : 8); ++i)
        {
            const double y = D == 2 ? i/2 - 1 : i/2 % 2 - 0.5;
            const double z = D == 2 ? 0 : i/4 - 0.5;
            centres.push_back(0.65*vec(2*(i % 2) - 1, D == 2 ? y : 2*y, 2*z));
        }
        const auto [where, size] = balls(D, centres);
        const int n = size;
        renewalChecks(t, where, [n](const int number) { return number < n; });
    }
    const scene tank(scene::tank(2));
    renewalChecks
    (
        t, tank, [&](const int number) { return tank.state.x[number][0] < 0.05; }
    );
    fallChecks(t);
}


// ************************************************************************* //
