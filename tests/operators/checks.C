/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checks.H"

#include <cmath>
#include <cstdio>
#include <iostream>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::tally::check(const std::string& what, const bool passed)
{
    (passed ? nPassed : nFailed) += 1;

    std::cout<< (passed ? "PASS  " : "FAIL  ") << what << std::endl;
}


void Foam::tally::check
(
    const std::string& what,
    const double error,
    const double bound
)
{
    check(what + ": " + text(error) + " <= " + text(bound), error <= bound);
}


void Foam::tally::checkAbove
(
    const std::string& what,
    const double difference,
    const double bound
)
{
    check
    (
        what + ": " + text(difference) + " > " + text(bound),
        difference > bound
    );
}


void Foam::deviation::add(const double value, const double exact)
{
    finite_ = finite_ && std::isfinite(value) && std::isfinite(exact);
    difference_ = std::max(difference_, std::abs(value - exact));
    size_ = std::max(size_, std::abs(exact));
}


void Foam::deviation::add(const vec& value, const vec& exact)
{
    finite_ = finite_ && value.allFinite() && exact.allFinite();
    difference_ = std::max(difference_, (value - exact).norm());
    size_ = std::max(size_, exact.norm());
}


void Foam::deviation::add(const mat& value, const mat& exact)
{
    for (int i = 0; i < 9; ++i)
    {
        add(value(i), exact(i));
    }
}


double Foam::deviation::absolute() const
{
    return finite_ ? difference_ : std::nan("");
}


double Foam::deviation::relative() const
{
    return size_ > 0 ? absolute()/size_ : absolute();
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::string Foam::text(const double x)
{
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.4g", x);

    return buffer;
}


// ************************************************************************* //
