/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Particles that come and go.

\*---------------------------------------------------------------------------*/

#include "ulphCloud.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::ulphCloud::valuesOfState() const
{
    // The number given at the start is the last
    label n = 1;
    for (const word& name : state_.toc())
    {
        n += state_[name]->nComponents();
    }
    return n;
}


std::vector<Foam::scalar> Foam::ulphCloud::stateOf
(
    const std::vector<int>& particles
) const
{
    const wordList names(state_.sortedToc());

    std::vector<scalar> values;
    values.reserve(particles.size()*valuesOfState());
    for (const int i : particles)
    {
        for (const word& name : names)
        {
            const particleField& field = *state_[name];
            for (int c = 0; c < field.nComponents(); ++c)
            {
                values.push_back(field(i, c));
            }
        }
        values.push_back(origId_[i]);
    }
    return values;
}


void Foam::ulphCloud::exchange
(
    const std::vector<int>& kept,
    const std::vector<scalar>& added
)
{
    const label nKept = label(kept.size());
    const label nAdded = label(added.size())/valuesOfState();
    nHalo_ = 0;
    size_ = nKept + nAdded;
    for (const word& name : state_.toc())
    {
        state_[name]->keep(kept, size_);
    }
    for (const word& name : derived_.toc())
    {
        nAdded ? derived_[name]->reset(size_) : derived_[name]->keep(kept, size_);
    }
    std::vector<label> ids;
    for (const int i : kept)
    {
        ids.push_back(origId_[i]);
    }

    const wordList names(state_.sortedToc());
    auto next = added.begin();
    for (label i = nKept; i < size_; ++i)
    {
        for (const word& name : names)
        {
            particleField& field = *state_[name];
            for (int c = 0; c < field.nComponents(); ++c)
            {
                field.set(i, c, *next++);
            }
        }
        ids.push_back(label(*next++));
    }
    origId_.swap(ids);
}


void Foam::ulphCloud::remove(const labelHashSet& removed)
{
    std::vector<int> kept;
    for (label i = 0; i < size_; ++i)
    {
        if (!removed.found(i))
        {
            kept.push_back(i);
        }
    }
    exchange(kept, {});
}


// ************************************************************************* //
