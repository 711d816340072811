// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motionBound.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ulph
{

void motionBound::range::include(const range& other, const int D)
{
    for (int k = 0; k < D; ++k)
    {
        lower[k] = std::min(lower[k], other.lower[k]);
        upper[k] = std::max(upper[k], other.upper[k]);
    }
}

float motionBound::range::farthest(const range& other, const int D) const
{
    double sum = 0;
    for (int k = 0; k < D; ++k)
    {
        const double d = std::max
        (
            double(upper[k]) - double(other.lower[k]),
            double(other.upper[k]) - double(lower[k])
        );
        sum += d*d;
    }
    return float(std::sqrt(sum));
}

motionBound::motionBound(const cellLayout& cells)
:
    cells_(cells),
    unit_(cells.size()/16384),
    perUnit_(1/unit_),
    place_(cells.nCells(), unoccupied)
{}

void motionBound::reset(const particleView& moving)
{
    for (int k = 0; k < moving.D; ++k)
    {
        const double* const x = moving.x[k];
        start_[k].resize(moving.n);

        #pragma omp parallel for simd schedule(static)
        for (int i = 0; i < moving.n; ++i)
        {
            start_[k][i] = packed(x[i]);
        }
    }
}

motionBound::range motionBound::overall(const particleView& moving) const
{
    range all;
    for (int k = 0; k < moving.D && moving.n; ++k)
    {
        const double* const x = moving.x[k];
        const std::uint16_t* const start = start_[k].data();
        float lower = std::numeric_limits<float>::max();
        float upper = -lower;

        #pragma omp parallel for simd schedule(static) \
            reduction(min : lower) reduction(max : upper)
        for (int i = 0; i < moving.n; ++i)
        {
            const float d = way(x[i], start[i]);
            lower = d < lower ? d : lower;
            upper = d > upper ? d : upper;
        }
        all.lower[k] = lower;
        all.upper[k] = upper;
    }
    return all;
}

double motionBound::farthest(const particleView& moving) const
{
    return overall(moving).farthest({}, moving.D) + rounding();
}

void motionBound::include(const int cell, const range& displacements)
{
    if (place_[cell] == unoccupied)
    {
        place_[cell] = int(occupied_.size());
        occupied_.push_back(cell);
        ranges_.push_back(displacements);
    }
    else
    {
        ranges_[place_[cell]].include(displacements, cells_.D());
    }
}

void motionBound::collect
(
    const particleView& moving,
    const particleView& atRest
)
{
    for (const int cell : occupied_)
    {
        place_[cell] = unoccupied;
    }
    occupied_.clear();
    ranges_.clear();
    for (int i = 0; i < atRest.n; ++i)
    {
        include(cells_.cellOf(atRest, i), {});
    }

    constexpr float none = std::numeric_limits<float>::max();
    const range empty{{none, none, none}, {-none, -none, -none}};

    // Particles are in order along a curve: a cell comes in few runs
    #pragma omp parallel
    {
        std::vector<std::pair<int, range>> runs;

        #pragma omp for schedule(static) nowait
        for (int i = 0; i < moving.n; ++i)
        {
            const int now = cells_.cellOf(moving, i);
            if (runs.empty() || runs.back().first != now)
            {
                runs.push_back({now, empty});
            }
            range& run = runs.back().second;
            for (int k = 0; k < moving.D; ++k)
            {
                const float d = way(moving.x[k][i], start_[k][i]);
                run.lower[k] = std::min(run.lower[k], d);
                run.upper[k] = std::max(run.upper[k], d);
            }
        }

        #pragma omp critical
        for (const auto& [cell, run] : runs)
        {
            include(cell, run);
        }
    }
}

motionBound::range motionBound::around(const int cell) const
{
    const std::array<int, 3> at(cells_.coordinates(cell));
    std::array<int, 3> lower{};
    std::array<int, 3> upper{};
    for (int k = 0; k < cells_.D(); ++k)
    {
        lower[k] = std::max(at[k] - 1, 0);
        upper[k] = std::min(at[k] + 1, cells_.extent(k) - 1);
    }

    range all = ranges_[place_[cell]];
    for (int k = lower[2]; k <= upper[2]; ++k)
    {
        for (int j = lower[1]; j <= upper[1]; ++j)
        {
            for (int i = lower[0]; i <= upper[0]; ++i)
            {
                const int place = place_[cells_.cell(i, j, k)];
                if (place != unoccupied)
                {
                    all.include(ranges_[place], cells_.D());
                }
            }
        }
    }
    return all;
}

bool motionBound::measure
(
    const particleView& moving,
    const particleView& atRest,
    const double limit
)
{
    range all(overall(moving));
    if (atRest.n)
    {
        all.include({}, moving.D);
    }
    if (all.farthest(all, moving.D) + rounding() <= limit)
    {
        return false;
    }

    // Close particles may still move together
    collect(moving, atRest);
    relative_.resize(occupied_.size());
    float largest = 0;

    #pragma omp parallel for schedule(static) reduction(max : largest)
    for (std::size_t i = 0; i < occupied_.size(); ++i)
    {
        relative_[i] =
            ranges_[i].farthest(around(occupied_[i]), moving.D) + rounding();
        largest = std::max(largest, relative_[i]);
    }
    return largest > limit;
}

std::size_t motionBound::bytes() const
{
    return place_.capacity()*sizeof(int)
      + occupied_.capacity()*(sizeof(int) + sizeof(float) + sizeof(range))
      + 3*start_[0].capacity()*sizeof(std::uint16_t);
}

} // End namespace ulph
