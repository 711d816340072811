// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motionBound.H"

#include <algorithm>
#include <limits>

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

double motionBound::range::extent2(const int D) const
{
    double sum = 0;
    for (int k = 0; k < D; ++k)
    {
        const double d = double(upper[k]) - double(lower[k]);
        sum += d*d;
    }
    return sum;
}

motionBound::motionBound(std::shared_ptr<const cellLayout> cells)
:
    cells_(std::move(cells))
{}

std::size_t motionBound::cellOf(const particleView& p, const int i) const
{
    std::size_t cell = 0;
    for (int k = p.D - 1; k >= 0; --k)
    {
        cell = cell*cells_->extent(k) + cells_->coordinate(k, p.x[k][i]);
    }
    return cell;
}

void motionBound::reset
(
    const particleView& moving,
    const particleView& atRest
)
{
    for (int k = 0; k < moving.D; ++k)
    {
        start_[k].assign(moving.x[k], moving.x[k] + moving.n);
    }
    place_.resize(cells_->nCells(), unoccupied);
    atRest_.assign(cells_->nCells(), 0);
    for (int i = 0; i < atRest.n; ++i)
    {
        atRest_[cellOf(atRest, i)] = 1;
    }
    anyAtRest_ = atRest.n > 0;
}

motionBound::range motionBound::overall(const particleView& moving) const
{
    range all{};
    for (int k = 0; k < moving.D; ++k)
    {
        const double* const x = moving.x[k];
        const float* const start = start_[k].data();
        float lower = std::numeric_limits<float>::max();
        float upper = -lower;

        #pragma omp parallel for simd schedule(static) \
            reduction(min : lower) reduction(max : upper)
        for (int i = 0; i < moving.n; ++i)
        {
            const float d = float(x[i] - double(start[i]));
            lower = d < lower ? d : lower;
            upper = d > upper ? d : upper;
        }
        all.lower[k] = lower;
        all.upper[k] = upper;
    }
    return all;
}

void motionBound::collect(const particleView& moving)
{
    constexpr float none = std::numeric_limits<float>::max();
    const range empty{{none, none, none}, {-none, -none, -none}};

    for (const std::size_t cell : occupied_)
    {
        place_[cell] = unoccupied;
    }
    occupied_.clear();
    ranges_.clear();

    // Particles are in order along a curve: a cell comes in few runs
    #pragma omp parallel
    {
        std::size_t cell = 0;
        range run = empty;
        const auto flush = [&]()
        {
            if (run.upper[0] < run.lower[0])
            {
                return;
            }
            #pragma omp critical
            {
                if (place_[cell] == unoccupied)
                {
                    place_[cell] = int(occupied_.size());
                    occupied_.push_back(cell);
                    ranges_.push_back(empty);
                }
                ranges_[place_[cell]].include(run, moving.D);
            }
        };

        #pragma omp for schedule(static)
        for (int i = 0; i < moving.n; ++i)
        {
            const std::size_t now = cellOf(moving, i);
            if (now != cell)
            {
                flush();
                cell = now;
                run = empty;
            }
            for (int k = 0; k < moving.D; ++k)
            {
                const float d = float(moving.x[k][i] - double(start_[k][i]));
                run.lower[k] = std::min(run.lower[k], d);
                run.upper[k] = std::max(run.upper[k], d);
            }
        }
        flush();
    }
}

motionBound::range motionBound::around(const std::size_t cell) const
{
    std::array<int, 3> lower{};
    std::array<int, 3> upper{};
    std::size_t rest = cell;
    for (int k = 0; k < cells_->D(); ++k)
    {
        const int n = cells_->extent(k);
        const int c = int(rest%n);
        rest /= n;
        lower[k] = std::max(c - 1, 0);
        upper[k] = std::min(c + 1, n - 1);
    }

    range all = ranges_[place_[cell]];
    for (int k = lower[2]; k <= upper[2]; ++k)
    {
        for (int j = lower[1]; j <= upper[1]; ++j)
        {
            for (int i = lower[0]; i <= upper[0]; ++i)
            {
                const std::size_t at =
                    (std::size_t(k)*cells_->extent(1) + j)*cells_->extent(0)
                  + i;
                if (place_[at] != unoccupied)
                {
                    all.include(ranges_[place_[at]], cells_->D());
                }
                if (atRest_[at])
                {
                    all.include({}, cells_->D());
                }
            }
        }
    }
    return all;
}

bool motionBound::exceeds
(
    const particleView& moving,
    const double limit,
    const double farthest
)
{
    if (moving.n == 0)
    {
        return false;
    }

    range all = overall(moving);
    for (int k = 0; k < moving.D; ++k)
    {
        if (std::max(-all.lower[k], all.upper[k]) > farthest)
        {
            return true;
        }
    }
    if (anyAtRest_)
    {
        all.include({}, moving.D);
    }
    if (all.extent2(moving.D) <= limit*limit)
    {
        return false;
    }

    // Close particles may still move together
    collect(moving);
    double largest = 0;

    #pragma omp parallel for schedule(static) reduction(max : largest)
    for (int i = 0; i < int(occupied_.size()); ++i)
    {
        largest = std::max(largest, around(occupied_[i]).extent2(moving.D));
    }
    return largest > limit*limit;
}

std::size_t motionBound::bytes() const
{
    return atRest_.capacity() + place_.capacity()*sizeof(int)
      + occupied_.capacity()*(sizeof(std::size_t) + sizeof(range))
      + 3*start_[0].capacity()*sizeof(float);
}

} // End namespace ulph
