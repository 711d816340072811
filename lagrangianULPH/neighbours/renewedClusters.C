/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "renewedClusters.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::renewedClusters::outdated
(
    const ulph::particleClusters& clusters,
    const ulph::particleView& particles,
    const listAge* sinceBuild,
    const listAge* sinceRenewal
)
{
    // Lists that are renewed today need not be tomorrow
    constexpr scalar nearlyAll = 0.5;

    isDue_.assign(clusters.size(), 0);
    bool any = false;

    #pragma omp parallel for schedule(static) reduction(|| : any)
    for (int c = 0; c < clusters.size(); ++c)
    {
        const listAge* const age = isRenewed_[c] ? sinceRenewal : sinceBuild;
        if (age)
        {
            const scalar way =
                age->relative(particles, clusters.first(c), clusters.count(c));
            any = any || way > age->skin();
            isDue_[c] = way > nearlyAll*age->skin();
        }
    }
    return any;
}


void Foam::renewedClusters::addDue()
{
    numbers_.clear();
    for (std::size_t c = 0; c < isRenewed_.size(); ++c)
    {
        isRenewed_[c] |= isDue_[c];
        if (isRenewed_[c])
        {
            numbers_.push_back(int(c));
        }
    }
}


// ************************************************************************* //
