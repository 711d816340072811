/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rankExchange.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static std::size_t total(const labelList& numbers)
{
    return std::accumulate(numbers.begin(), numbers.end(), std::size_t(0));
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::rankExchange::exchange
(
    const labelList& nOut,
    const std::vector<scalar>& out,
    const labelList& nIn,
    std::vector<scalar>& in,
    const label perItem
)
{
    const label me = UPstream::myProcNo();
    const label request = UPstream::nRequests();

    std::size_t first = 0;
    std::size_t ownIn = 0;
    forAll(nIn, rank)
    {
        const std::size_t n = std::size_t(nIn[rank])*perItem;
        if (rank == me)
        {
            ownIn = first;
        }
        else if (n)
        {
            UIPstream::read
            (
                UPstream::commsTypes::nonBlocking, rank,
                reinterpret_cast<char*>(in.data() + first), n*sizeof(scalar)
            );
        }
        first += n;
    }

    first = 0;
    forAll(nOut, rank)
    {
        const std::size_t n = std::size_t(nOut[rank])*perItem;
        if (rank == me)
        {
            std::copy_n(out.data() + first, n, in.data() + ownIn);
        }
        else if (n)
        {
            UOPstream::write
            (
                UPstream::commsTypes::nonBlocking, rank,
                reinterpret_cast<const char*>(out.data() + first),
                n*sizeof(scalar)
            );
        }
        first += n;
    }
    UPstream::waitRequests(request);
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
    std::vector<scalar> in(total(received_)*perItem);
    exchange(sent_, values, received_, in, perItem);
    return in;
}


std::vector<Foam::scalar> Foam::rankExchange::back
(
    const std::vector<scalar>& values,
    const label perItem
) const
{
    std::vector<scalar> in(total(sent_)*perItem);
    exchange(received_, values, sent_, in, perItem);
    return in;
}


// ************************************************************************* //
