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
    atRest_.assign(cells_->nCells(), 0);
    for (int i = 0; i < atRest.n; ++i)
    {
        atRest_[cellOf(atRest, i)] = 1;
    }
}

void motionBound::collect(const particleView& moving)
{
    constexpr float none = std::numeric_limits<float>::max();
    const range empty{{none, none, none}, {-none, -none, -none}};

    ranges_.assign(cells_->nCells(), empty);
    for (std::size_t c = 0; c < ranges_.size(); ++c)
    {
        if (atRest_[c])
        {
            ranges_[c] = {{0, 0, 0}, {0, 0, 0}};
        }
    }

    // Particles are in order along a curve: a cell comes in few runs
    #pragma omp parallel
    {
        std::size_t cell = 0;
        range run = empty;
        const auto flush = [&]()
        {
            #pragma omp critical
            ranges_[cell].include(run, moving.D);
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

void motionBound::spread(const int d)
{
    std::size_t stride = 1;
    for (int k = 0; k < d; ++k)
    {
        stride *= cells_->extent(k);
    }
    const int n = cells_->extent(d);
    const std::size_t nLines = ranges_.size()/n;

    for (std::size_t line = 0; line < nLines; ++line)
    {
        range* const first =
            ranges_.data() + line%stride + line/stride*stride*n;

        range before = first[0];
        for (int i = 0; i < n; ++i)
        {
            range& here = first[i*stride];
            const range mine = here;
            here.include(before, cells_->D());
            if (i + 1 < n)
            {
                here.include(first[(i + 1)*stride], cells_->D());
            }
            before = mine;
        }
    }
}

bool motionBound::exceeds
(
    const particleView& moving,
    const double limit,
    const double farthest
)
{
    collect(moving);
    for (int d = 0; d < moving.D; ++d)
    {
        spread(d);
    }

    double largest = 0;
    double largest2 = 0;
    for (const range& r : ranges_)
    {
        double length2 = 0;
        for (int k = 0; k < moving.D; ++k)
        {
            const double d = double(r.upper[k]) - double(r.lower[k]);
            length2 += d > 0 ? d*d : 0;
            if (d >= 0)
            {
                largest = std::max(largest, double(-r.lower[k]));
                largest = std::max(largest, double(r.upper[k]));
            }
        }
        largest2 = std::max(largest2, length2);
    }
    return largest2 > limit*limit || largest > farthest;
}

std::size_t motionBound::bytes() const
{
    return atRest_.capacity() + ranges_.capacity()*sizeof(range)
      + 3*start_[0].capacity()*sizeof(float);
}

} // End namespace ulph
