/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rankExchange.H"
#include "Pstream.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<Foam::scalar> Foam::rankExchange::exchange
(
    const labelList& nOut,
    const std::vector<scalar>& out,
    const labelList& nIn,
    const label perItem
)
{
    List<List<scalar>> toRank(nOut.size());
    labelList nFrom(nIn.size());
    auto next = out.begin();
    forAll(toRank, rank)
    {
        nFrom[rank] = nIn[rank]*perItem;
        toRank[rank].resize(nOut[rank]*perItem);
        std::copy_n(next, toRank[rank].size(), toRank[rank].begin());
        next += toRank[rank].size();
    }

    List<List<scalar>> fromRank;
    Pstream::exchange<List<scalar>, scalar>(toRank, nFrom, fromRank);

    std::vector<scalar> in;
    for (const List<scalar>& values : fromRank)
    {
        in.insert(in.end(), values.begin(), values.end());
    }
    return in;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rankExchange::rankExchange(const labelList& sent)
:
    sent_(sent),
    received_(sent)
{
    if (UPstream::parRun())
    {
        UPstream::allToAll(sent_, received_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<Foam::scalar> Foam::rankExchange::forth
(
    const std::vector<scalar>& values,
    const label perItem
) const
{
    return exchange(sent_, values, received_, perItem);
}


std::vector<Foam::scalar> Foam::rankExchange::back
(
    const std::vector<scalar>& values,
    const label perItem
) const
{
    return exchange(received_, values, sent_, perItem);
}


// ************************************************************************* //
