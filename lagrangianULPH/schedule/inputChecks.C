/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "inputChecks.H"

#include "error.H"
#include "ListOps.H"
#include "stringOps.H"

#include <numeric>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Letters to insert, remove or replace to come from one word to the other
static std::size_t editDistance(const std::string& a, const std::string& b)
{
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (const char letter : a)
    {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
            const std::size_t replaced = diagonal + (letter != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}


static scalar checked
(
    const dictionary& dict,
    const word& keyword,
    const scalar value,
    const scalarMinMax& range
)
{
    if (!range.contains(value))
    {
        Ostream& os =
            FatalIOErrorInFunction(entryPlace(dict, keyword))
                << keyword << " is " << value << ", but must be ";

        if (range.max() <= GREAT)
        {
            os  << "from " << range.min() << " to " << range.max();
        }
        else if (range.min() > 0 && range.min() <= SMALL)
        {
            os  << "above zero";
        }
        else
        {
            os  << range.min() << " or more";
        }
        os  << exit(FatalIOError);
    }
    return value;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::entryPlace(const dictionary& dict, const word& keyword)
{
    const entry* const e = dict.findEntry(keyword, keyType::LITERAL);
    if (!e)
    {
        return dict;
    }
    dictionary place(dict.name());
    place.add(*e);
    return place;
}


Foam::scalar Foam::getInRange
(
    const dictionary& dict,
    const word& keyword,
    const scalarMinMax& range
)
{
    return checked(dict, keyword, dict.get<scalar>(keyword), range);
}


Foam::scalar Foam::getInRange
(
    const dictionary& dict,
    const word& keyword,
    const scalar deflt,
    const scalarMinMax& range
)
{
    return checked
    (
        dict, keyword, dict.getOrDefault<scalar>(keyword, deflt), range
    );
}


void Foam::refuseMisspelt(const dictionary& dict, const wordList& valid)
{
    for (const entry& e : dict)
    {
        if (e.keyword().isPattern() || valid.found(e.keyword()))
        {
            continue;
        }
        const std::string given(stringOps::lower(e.keyword()));
        for (const word& name : valid)
        {
            if
            (
                !dict.found(name, keyType::LITERAL)
             && 3*editDistance(given, stringOps::lower(name)) <= given.size()
            )
            {
                FatalIOErrorInFunction(entryPlace(dict, e.keyword()))
                    << "Unknown entry " << e.keyword() << ": is " << name
                    << " meant?" << nl << nl
                    << "Valid entries are" << nl << flatOutput(valid) << nl
                    << exit(FatalIOError);
            }
        }
    }
}


void Foam::warnOfUnknown(const dictionary& dict, const wordList& valid)
{
    for (const entry& e : dict)
    {
        if (!e.keyword().isPattern() && !valid.found(e.keyword()))
        {
            IOWarningInFunction(entryPlace(dict, e.keyword()))
                << "Nothing reads the entry " << e.keyword() << nl << nl
                << "Valid entries are" << nl << flatOutput(valid) << nl << endl;
        }
    }
}


// ************************************************************************* //
