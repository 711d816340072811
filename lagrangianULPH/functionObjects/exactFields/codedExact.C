/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "codedExact.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace exactFields
{
    defineTypeNameAndDebug(codedExact, 0);
    addToRunTimeSelectionTable(exactField, codedExact, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exactFields::codedExact::codedExact
(
    const dictionary& dict,
    const ulphCloud&
)
:
    U_(dict.subDict("U")),
    p_(dict.subDict("p")),
    relativePressure_(dict.getOrDefault("relativePressure", false))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::exactFields::codedExact::setTime(const scalar t)
{
    time_ = t;
}


Foam::vector Foam::exactFields::codedExact::U(const point& x) const
{
    vector value;
    U_.evaluate(time_, &x, &value, 1);
    return value;
}


Foam::scalar Foam::exactFields::codedExact::p(const point& x) const
{
    scalar value;
    p_.evaluate(time_, &x, &value, 1);
    return value;
}


// ************************************************************************* //
