/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentMatrixFreeSurface.H"
#include "clusterShares.H"
#include "neighbourSearch.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::freeSurfaces::momentMatrixFreeSurface::lookAround
(
    const neighbourSearch& search,
    const ulph::clusterList::cluster& c,
    ulph::laneRow& sawFluid
)
{
    const particleField& x = search.cloud().x();

    using lanes = ulph::stdx::native_simd<double>;
    constexpr int width = int(lanes::size());
    constexpr auto aligned = ulph::stdx::element_aligned;
    const lanes number([](const auto l) { return double(int(l)); });

    ulph::laneRow rows[3] = {};
    ulph::laneRow on = {};
    x.load(c.first, c.count, rows);
    std::copy_n(onSurface_.data() + c.first, c.count, on);

    for (int first = 0; first < c.count; first += width)
    {
        lanes members[3];
        for (int k = 0; k < D_; ++k)
        {
            members[k] = lanes(rows[k] + first, aligned);
        }
        const auto isOn = lanes(on + first, aligned) > 0;
        auto saw = !isOn;
        if (all_of(saw))
        {
            continue;
        }
        bool allSaw = false;
        search.fluidList().fluid(c).goThrough([&](const std::uint32_t j)
        {
            // Others on the surface may have marked it before
            unsigned char marked;
            #pragma omp atomic read
            marked = nearSurface_[j];
            if (allSaw && (marked || onSurface_[j]))
            {
                return true;
            }

            lanes r2 = 0;
            for (int k = 0; k < D_; ++k)
            {
                const lanes d = x.component(k)[j] - members[k];
                r2 += d*d;
            }
            const scalar self = label(j) - c.first - first;
            const auto isNear = r2 < sqr(2*h_) && isOn && number != self;
            saw = saw || isNear;
            allSaw = all_of(saw);
            if (any_of(isNear))
            {
                #pragma omp atomic write
                nearSurface_[j] = 1;
            }
            return true;
        });
        for (int l = 0; l < width; ++l)
        {
            sawFluid[first + l] = saw[l];
        }
    }
}


void Foam::freeSurfaces::momentMatrixFreeSurface::markVicinity
(
    const neighbourSearch& search
)
{
    const ulph::clusterList& list = search.fluidList();
    const auto first = [&](const std::vector<unsigned char>& marks, const int i)
    {
        return marks.data() + list[i].first;
    };
    const auto any = [&](const std::vector<unsigned char>& marks, const int i)
    {
        return std::find(first(marks, i), first(marks, i) + list[i].count, 1)
         != first(marks, i) + list[i].count;
    };

    // Particles see each other: the few on the surface look for the others
    class_->reset(lambda_->size());
    nearSurface_.assign(lambda_->size(), 0);

    ulph::clusterShares shares(list.size());

    #pragma omp parallel
    for (const int i : shares)
    {
        if (any(onSurface_, i))
        {
            ulph::laneRow sawFluid = {};
            ulph::laneRow classes;
            lookAround(search, list[i], sawFluid);
            for (int l = 0; l < list[i].count; ++l)
            {
                classes[l] = sawFluid[l] ? surface : splash;
            }
            class_->store(0, list[i].first, list[i].count, classes);
        }
    }
    search.halo().markSources(nearSurface_);

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < list.size(); ++i)
    {
        const bool anyOn = any(onSurface_, i);
        mask_[i] = (anyOn || any(nearSurface_, i)) && !known_[i];
        for (label p = list[i].first; p < list[i].first + list[i].count; ++p)
        {
            if (!onSurface_[p])
            {
                class_->set(p, 0, nearSurface_[p] ? vicinity : interior);
            }
        }
    }
}


// ************************************************************************* //
