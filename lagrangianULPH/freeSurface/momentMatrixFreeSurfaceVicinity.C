/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentMatrixFreeSurface.H"
#include "neighbourSearch.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::freeSurfaces::momentMatrixFreeSurface::markVicinity
(
    const neighbourSearch& search
)
{
    const ulph::clusterList& list = search.fluidList();
    const particleField& x = search.cloud().x();

    class_->reset(lambda_->size());

    #pragma omp parallel for schedule(dynamic, 16)
    for (int i = 0; i < list.size(); ++i)
    {
        const ulph::clusterList::cluster& c = list[i];
        const std::uint32_t* const first = list.neighbours(c) + c.begin;
        const std::uint32_t* const last = list.neighbours(c) + c.fluidEnd;

        // Members that have seen a surface particle, and any fluid, in reach
        ulph::laneRow sawSurface = {};
        ulph::laneRow sawFluid = {};
        ulph::laneRow members[3] = {};
        for (int k = 0; k < D_; ++k)
        {
            x.load(k, c.first, c.count, members[k]);
        }
        // Over all lanes, so that the length of the loops is known: lanes
        // beyond the members are not read
        const auto look = [&](const std::uint32_t j, ulph::laneRow& saw)
        {
            ulph::laneRow r2 = {};
            for (int k = 0; k < D_; ++k)
            {
                const scalar xj = x.component(k)[j];
                for (int l = 0; l < ulph::maxLanes; ++l)
                {
                    r2[l] += sqr(xj - members[k][l]);
                }
            }
            const label self = label(j) - c.first;
            const scalar before =
                self >= 0 && self < c.count ? saw[self] : 0;
            for (int l = 0; l < ulph::maxLanes; ++l)
            {
                saw[l] = r2[l] < sqr(2*h_) ? 1 : saw[l];
            }
            if (self >= 0 && self < c.count)
            {
                saw[self] = before;
            }
        };

        bool any = false;
        for (const std::uint32_t* j = first; j != last; ++j)
        {
            if (onSurface_[*j])
            {
                any = true;
                look(*j, sawSurface);
            }
        }
        mask_[i] = any && !known_[i];

        const unsigned char* const on = onSurface_.data() + c.first;
        if (std::find(on, on + c.count, 1) != on + c.count)
        {
            const auto lonely = [&]()
            {
                bool found = false;
                for (int l = 0; l < c.count; ++l)
                {
                    found = found || (on[l] && sawFluid[l] == 0);
                }
                return found;
            };
            // Members of a cluster are close to each other, as a rule
            for (int l = 0; l < c.count; ++l)
            {
                look(std::uint32_t(c.first + l), sawFluid);
            }
            for (const std::uint32_t* j = first; j != last && lonely(); ++j)
            {
                look(*j, sawFluid);
            }
        }

        ulph::laneRow classes;
        for (int l = 0; l < c.count; ++l)
        {
            classes[l] =
                on[l] ? (sawFluid[l] > 0 ? surface : splash)
              : sawSurface[l] > 0 ? vicinity : interior;
        }
        class_->store(0, c.first, c.count, classes);
    }
}


// ************************************************************************* //
