/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "logLawWall.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"
#include "mathematicalConstants.H"


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace walls
{
    defineTypeNameAndDebug(logLawWall, 0);
    addToRunTimeSelectionTable(wall, logLawWall, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static scalar differencePerStress
(
    const dictionary& dict,
    const ulphCloud& cloud,
    const viscosity& viscous
)
{
    if (viscous.mu() <= 0)
    {
        FatalIOErrorInFunction(entryPlace(dict.parent(), "viscosity"))
            << "wall logLaw acts by the viscous force, but viscosity is "
            << viscous.model() << '.' << nl
            << "    Set viscosity { type artificial; alpha 0.002; }, or another "
            << "one that is not zero."
            << exit(FatalIOError);
    }
    return cloud.dx()/(0.8*viscous.nu(cloud));
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::walls::logLawWall::uTau2(const scalar U) const
{
    const scalar laminar = nu_*U/y_;

    // The logarithm changes little: each round leaves a tenth of the error
    scalar uTau = 0.05*U;
    for (int round = 0; round < 3; ++round)
    {
        const scalar yPlus = y_*uTau/nu_;
        if (E_*yPlus <= constant::mathematical::e)
        {
            return laminar;
        }
        uTau = kappa_*U/std::log(E_*yPlus);
    }
    return max(sqr(uTau), laminar);
}


Foam::scalar Foam::walls::logLawWall::difference(const scalar U) const
{
    return min(perStress_*uTau2(U), 2*U);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::walls::logLawWall::logLawWall
(
    const dictionary& dict,
    const ulphCloud& cloud,
    const viscosity& viscous
)
:
    D_(cloud.D()),
    y_(cloud.dx()),
    nu_(getInRange(dict, "nu", scalarMinMax::ge(VSMALL))),
    kappa_(getInRange(dict, "kappa", 0.41, scalarMinMax::ge(SMALL))),
    E_(getInRange(dict, "E", 9.8, scalarMinMax::ge(1))),
    perStress_(differencePerStress(dict, cloud, viscous))
{
    refuseMisspelt(dict, {"type", "nu", "kappa", "E"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::walls::logLawWall::viscousVelocity
(
    const label count,
    const ulph::laneRow* fluid,
    const ulph::laneRow* reflected,
    ulph::laneRow* v
) const
{
    for (label l = 0; l < count; ++l)
    {
        // What walls reflect is along their normal
        scalar turned2 = 0;
        scalar along = 0;
        for (int k = 0; k < D_; ++k)
        {
            const scalar turned = fluid[k][l] - reflected[k][l];
            turned2 += sqr(turned);
            along += turned*fluid[k][l];
        }
        const scalar normalPart = turned2 > VSMALL ? along/turned2 : 0;

        scalar tangential[3] = {};
        scalar U2 = 0;
        for (int k = 0; k < D_; ++k)
        {
            tangential[k] =
                fluid[k][l] - normalPart*(fluid[k][l] - reflected[k][l]);
            U2 += sqr(tangential[k]);
        }
        const scalar U = std::sqrt(U2);
        const scalar slowed = U > VSMALL ? difference(U)/U : 0;
        for (int k = 0; k < D_; ++k)
        {
            v[k][l] = reflected[k][l] - slowed*tangential[k];
        }
    }
}


// ************************************************************************* //
