/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentDensityRelaxation.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"
#include "symmetric.H"
#include "MinMax.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace densityRelaxations
{
    defineTypeNameAndDebug(momentDensityRelaxation, 0);
    addToRunTimeSelectionTable
    (
        densityRelaxation, momentDensityRelaxation, dictionary
    );
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::densityRelaxations::momentDensityRelaxation::momentDensityRelaxation
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    D_(cloud.D()),
    trace_(cloud.D()*cloud.shared().beta),
    rate_
    (
        dict.getCheckOrDefault<scalar>("k", 0.005, scalarMinMax::ge(0))
       *cloud.c0()*cloud.rho0()/cloud.h()
    )
{
    refuseMisspelt(dict, {"type", "k"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::effectNeeds Foam::densityRelaxations::momentDensityRelaxation::needs() const
{
    effectNeeds all;
    all.fields.set("densityRelaxation", 1);
    all.geometry = ulph::momentSums;
    return all;
}


void Foam::densityRelaxations::momentDensityRelaxation::rate
(
    const ulph::geometryBlock& sums,
    ulph::laneRow& rate
) const
{
    for (int l = 0; l < sums.count; ++l)
    {
        scalar trace = 0;
        for (int k = 0; k < D_; ++k)
        {
            trace += sums.M[ulph::symmetricIndex(D_, k, k)][l];
        }
        rate[l] = rate_*(trace/trace_ - 1);
    }
}


// ************************************************************************* //
// ************************************************************************* //
