/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "XuStansbyLaurenceShifting.H"
#include "addToRunTimeSelectionTable.H"
#include "inputChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace shiftings
{
    defineTypeNameAndDebug(XuStansbyLaurenceShifting, 0);
    addToRunTimeSelectionTable(shifting, XuStansbyLaurenceShifting, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::shiftings::XuStansbyLaurenceShifting::XuStansbyLaurenceShifting
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    shifting
    (
        getInRange(dict, "C", 0.04, scalarMinMax::ge(0)),
        cloud
    )
{
    refuseMisspelt(dict, {"type", "C"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::shiftings::XuStansbyLaurenceShifting::direction
(
    const ulph::geometryBlock& sums,
    ulph::laneRow* R
) const
{
    for (int k = 0; k < D_; ++k)
    {
        for (int l = 0; l < sums.count; ++l)
        {
            R[k][l] =
                sums.n[l] > 0
              ? sqr(sums.d[l]/sums.n[l])*sums.e[k][l]
              : 0;
        }
    }
}


Foam::effectNeeds Foam::shiftings::XuStansbyLaurenceShifting::needs() const
{
    effectNeeds all(shifting::needs());
    all.geometry |= ulph::spacingSums;
    return all;
}


// ************************************************************************* //
