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

    using lanes = ulph::stdx::native_simd<double>;
    constexpr int width = int(lanes::size());
    constexpr int nRegisters = ulph::maxLanes/width;
    constexpr auto aligned = ulph::stdx::element_aligned;
    const lanes number([](const auto l) { return double(int(l)); });

    class_->reset(lambda_->size());

    #pragma omp parallel for schedule(dynamic, 16)
    for (int i = 0; i < list.size(); ++i)
    {
        const ulph::clusterList::cluster& c = list[i];
        const ulph::clusterList::sources fluid(list.fluid(c));

        // Idle lanes repeat the last member
        const int nUsed = (c.count + width - 1)/width;
        lanes members[nRegisters][3];
        ulph::laneRow rows[3];
        x.load(c.first, c.count, rows);
        for (int k = 0; k < D_; ++k)
        {
            std::fill(rows[k] + c.count, rows[k] + nUsed*width, rows[k][c.count - 1]);
            for (int m = 0; m < nUsed; ++m)
            {
                members[m][k] = lanes(rows[k] + m*width, aligned);
            }
        }

        // Members that have seen a surface particle, and any fluid, in reach
        lanes::mask_type sawSurface[nRegisters];
        lanes::mask_type sawFluid[nRegisters];
        for (int m = 0; m < nUsed; ++m)
        {
            sawSurface[m] = sawFluid[m] = lanes::mask_type(false);
        }
        const auto look = [&](const std::uint32_t j, lanes::mask_type* saw)
        {
            bool all = true;
            for (int m = 0; m < nUsed; ++m)
            {
                lanes r2 = 0;
                for (int k = 0; k < D_; ++k)
                {
                    const lanes d = x.component(k)[j] - members[m][k];
                    r2 += d*d;
                }
                const scalar self = label(j) - c.first - m*width;
                saw[m] = saw[m] || (r2 < sqr(2*h_) && number != self);
                all = all && all_of(saw[m]);
            }
            return all;
        };

        bool any = false;
        fluid.goThrough([&](const std::uint32_t j)
        {
            if (!onSurface_[j])
            {
                return true;
            }
            any = true;
            return !look(j, sawSurface);
        });
        mask_[i] = any && !known_[i];

        const unsigned char* const on = onSurface_.data() + c.first;
        if (std::find(on, on + c.count, 1) != on + c.count)
        {
            const auto lonely = [&]()
            {
                bool found = false;
                for (int l = 0; l < c.count; ++l)
                {
                    found = found || (on[l] && !sawFluid[l/width][l % width]);
                }
                return found;
            };
            // Members of a cluster are close to each other, as a rule
            for (int l = 0; l < c.count; ++l)
            {
                look(std::uint32_t(c.first + l), sawFluid);
            }
            if (lonely())
            {
                fluid.goThrough([&](const std::uint32_t j)
                {
                    look(j, sawFluid);
                    return lonely();
                });
            }
        }

        ulph::laneRow classes;
        for (int l = 0; l < c.count; ++l)
        {
            classes[l] =
                on[l] ? (sawFluid[l/width][l % width] ? surface : splash)
              : sawSurface[l/width][l % width] ? vicinity : interior;
        }
        class_->store(0, c.first, c.count, classes);
    }
}


// ************************************************************************* //
