/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "PoiseuilleExact.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace exactFields
{
    defineTypeNameAndDebug(PoiseuilleExact, 0);
    addToRunTimeSelectionTable(exactField, PoiseuilleExact, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactFields::PoiseuilleExact::PoiseuilleExact
(
    const dictionary& dict,
    const ulphCloud&
)
:
    acceleration_(dict.get<vector>("acceleration")),
    nu_(dict.get<scalar>("nu")),
    H_(dict.get<scalar>("H")),
    origin_(dict.getOrDefault<point>("origin", Zero)),
    normal_(normalised(dict.getOrDefault<vector>("normal", vector(0, 1, 0)))),
    pRef_(dict.getOrDefault<scalar>("pRef", 0))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::exactFields::PoiseuilleExact::setTime(const scalar t)
{
    t_ = t;
}


Foam::vector Foam::exactFields::PoiseuilleExact::U(const point& x) const
{
    // Smaller terms are below the round-off error
    constexpr scalar smallest = 40;
    constexpr label terms = 200;

    const scalar y = ((x - origin_) & normal_)/H_;
    scalar factor = 0.5*y*(1 - y);
    for (label k = 1; k < 2*terms; k += 2)
    {
        const scalar wave = constant::mathematical::pi*k;
        const scalar decay = sqr(wave/H_)*nu_*t_;
        if (decay > smallest)
        {
            break;
        }
        factor -= 4*std::sin(wave*y)*std::exp(-decay)/pow3(wave);
    }
    return factor*sqr(H_)/nu_*acceleration_;
}


Foam::scalar Foam::exactFields::PoiseuilleExact::p(const point&) const
{
    return pRef_;
}


// ************************************************************************* //
