// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleClusters.H"

#include <algorithm>
#include <omp.h>
#include <utility>

namespace ulph
{

namespace
{

struct place
{
    float x[3];
    int particle;
};

// Halve [first, last) until clusters are left: all of them whole but the last.
// Where places are the same the order before decides: what is in order stays so.
void halve(place* const first, place* const last, const int width, const int D)
{
    const int n = int(last - first);
    if (n <= width)
    {
        std::sort
        (
            first, last,
            [](const place& a, const place& b) { return a.particle < b.particle; }
        );
        return;
    }

    int longest = 0;
    float edge = 0;
    for (int k = 0; k < D; ++k)
    {
        float lower = first->x[k];
        float upper = lower;
        for (const place* p = first; p != last; ++p)
        {
            lower = std::min(lower, p->x[k]);
            upper = std::max(upper, p->x[k]);
        }
        if (upper - lower > edge)
        {
            longest = k;
            edge = upper - lower;
        }
    }

    const int nClusters = (n + width - 1)/width;
    place* const middle = first + nClusters/2*width;
    std::nth_element
    (
        first, middle, last,
        [longest](const place& a, const place& b)
        {
            return
                a.x[longest] != b.x[longest]
              ? a.x[longest] < b.x[longest]
              : a.particle < b.particle;
        }
    );
    halve(first, middle, width, D);
    halve(middle, last, width, D);
}

} // End anonymous namespace

particleBox::particleBox(const particleView& p, const int first, const int count)
{
    for (int k = 0; k < p.D; ++k)
    {
        const auto range =
            std::minmax_element(p.x[k] + first, p.x[k] + first + count);
        lower[k] = *range.first;
        upper[k] = *range.second;
    }
}

cellCurve::cellCurve(const cellLayout& layout)
:
    cells(layout),
    along(layout.hilbertCurve()),
    place(along.size())
{
    for (std::size_t i = 0; i < along.size(); ++i)
    {
        place[along[i]] = int(i);
    }
}

particleClusters::particleClusters(std::shared_ptr<const cellCurve> curve)
:
    curve_(std::move(curve)),
    number_(curve_->place.size(), none)
{}

particleOrder particleClusters::sort
(
    const particleView& particles,
    const int clusterWidth
)
{
    const int n = particles.n;
    unsetVector<int> placeOf(n);
    particleOrder order(n);

    // Of each cell along the curve the first particle
    std::vector<int> start(number_.size() + 1, n);

    // Of each thread and cell how many particles, then where the next one goes
    std::vector<std::vector<int>> next
    (
        omp_get_max_threads(), std::vector<int>(number_.size(), 0)
    );

    #pragma omp parallel
    {
        std::vector<int>& own = next[omp_get_thread_num()];

        #pragma omp for schedule(static)
        for (int i = 0; i < n; ++i)
        {
            placeOf[i] = curve_->place[curve_->cells.cellOf(particles, i)];
            ++own[placeOf[i]];
        }

        #pragma omp single
        {
            int sum = 0;
            for (std::size_t place = 0; place < number_.size(); ++place)
            {
                start[place] = sum;
                for (std::vector<int>& ofThread : next)
                {
                    sum += std::exchange(ofThread[place], sum);
                }
            }
        }

        #pragma omp for schedule(static)
        for (int i = 0; i < n; ++i)
        {
            order[own[placeOf[i]]++] = i;
        }
    }

    cells_.clear();
    first_.clear();
    for (std::size_t place = 0; place < number_.size(); ++place)
    {
        const int begin = start[place];
        const int count = start[place + 1] - begin;
        number_[curve_->along[place]] = count ? int(cells_.size()) : none;
        if (count)
        {
            cells_.push_back
            (
                {
                    begin,
                    count,
                    int(first_.size()),
                    (count + clusterWidth - 1)/clusterWidth,
                    curve_->cells.coordinates(curve_->along[place]),
                    {}
                }
            );
        }
        for (int i = begin; i < begin + count; i += clusterWidth)
        {
            first_.push_back(i);
        }
    }
    first_.push_back(n);

    #pragma omp parallel for schedule(dynamic, 4)
    for (std::size_t c = 0; c < cells_.size(); ++c)
    {
        halveCell(particles, cells_[c], clusterWidth, order);
    }
    return order;
}

void particleClusters::halveCell
(
    const particleView& particles,
    const cell& now,
    const int clusterWidth,
    particleOrder& order
) const
{
    int* const own = order.data() + now.first;
    thread_local std::vector<place> places;
    places.resize(now.count);
    for (int i = 0; i < now.count; ++i)
    {
        places[i].particle = own[i];
        for (int k = 0; k < particles.D; ++k)
        {
            const cellLayout& layout = curve_->cells;
            places[i].x[k] = float
            (
                particles.x[k][own[i]]
              - (layout.lower()[k] + now.at[k]*layout.size())
            );
        }
    }
    halve(places.data(), places.data() + now.count, clusterWidth, particles.D);
    for (int i = 0; i < now.count; ++i)
    {
        own[i] = places[i].particle;
    }
}

double particleClusters::strayed(const cell& now, const int D) const
{
    const cellLayout& layout = curve_->cells;
    double farthest = 0;
    for (int k = 0; k < D; ++k)
    {
        // The outermost cells have what lies beyond, too
        const int c = now.at[k];
        const double lower = layout.lower()[k] + c*layout.size();
        farthest = std::max
        (
            {
                farthest,
                c == 0 ? 0.0 : lower - now.box.lower[k],
                c == layout.extent(k) - 1
              ? 0.0
              : now.box.upper[k] - lower - layout.size()
            }
        );
    }
    return farthest;
}

void particleClusters::fit(const particleView& particles)
{
    const int D = particles.D;
    for (int k = 0; k < D; ++k)
    {
        lower_[k].resize(size() + width);
        upper_[k].resize(size() + width);
    }

    double farthest = 0;
    #pragma omp parallel for schedule(static) reduction(max : farthest)
    for (std::size_t n = 0; n < cells_.size(); ++n)
    {
        cell& now = cells_[n];
        now.box = particleBox(particles, now.first, now.count);
        farthest = std::max(farthest, strayed(now, D));

        for (int c = now.firstCluster; c < now.firstCluster + now.nClusters; ++c)
        {
            const particleBox box(particles, first(c), count(c));
            for (int k = 0; k < D; ++k)
            {
                lower_[k][c] = float(box.lower[k] - now.box.centre(k));
                upper_[k][c] = float(box.upper[k] - now.box.centre(k));
            }
        }
    }
    stray_ = farthest;
}

std::size_t particleClusters::bytes() const
{
    return sizeof(int)*(first_.capacity() + number_.capacity())
      + sizeof(cell)*cells_.capacity()
      + 6*sizeof(float)*lower_[0].capacity();
}

} // End namespace ulph
