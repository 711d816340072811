// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

#include "clusterList.H"

#include <algorithm>
#include <limits>
#include <omp.h>

namespace ulph
{

namespace
{

struct box
{
    std::array<double, 3> lower{};
    std::array<double, 3> upper{};
};

box boundingBox(const particleView& p, const int first, const int count)
{
    box b;
    for (int k = 0; k < p.D; ++k)
    {
        const auto range =
            std::minmax_element(p.x[k] + first, p.x[k] + first + count);
        b.lower[k] = *range.first;
        b.upper[k] = *range.second;
    }
    return b;
}

// Append the sources closer to the box than reach, cell by cell
void listSources
(
    const clusterList::sourceGroup& group,
    const box& b,
    const double reach,
    std::vector<std::uint32_t>& listed
)
{
    if (!group.grid || group.particles.n == 0)
    {
        return;
    }

    const cellLayout& cells = group.grid->layout();
    const particleView& p = group.particles;
    const int D = p.D;
    const double reach2 = reach*reach;

    std::array<int, 3> lower{0, 0, 0};
    std::array<int, 3> upper{0, 0, 0};
    for (int k = 0; k < D; ++k)
    {
        lower[k] = cells.coordinate(k, b.lower[k] - reach);
        upper[k] = cells.coordinate(k, b.upper[k] + reach);
    }

    const auto scan = [&](const auto dims, const int first, const int last)
    {
        std::size_t end = listed.size();
        listed.resize(end + last - first);
        for (int j = first; j < last; ++j)
        {
            double d2 = 0;
            for (int k = 0; k < decltype(dims)::value; ++k)
            {
                const double x = p.x[k][j];
                const double d =
                    std::max(0.0, std::max(b.lower[k] - x, x - b.upper[k]));
                d2 += d*d;
            }
            listed[end] = std::uint32_t(group.offset + j);
            end += d2 < reach2;
        }
        listed.resize(end);
    };

    for (int k = lower[2]; k <= upper[2]; ++k)
    {
        for (int j = lower[1]; j <= upper[1]; ++j)
        {
            for (int i = lower[0]; i <= upper[0]; ++i)
            {
                const int r = cells.rank(i, j, k);
                const int first = group.grid->first(r);
                const int last = group.grid->first(r + 1);
                if (first == last)
                {
                    continue;
                }
                if (D == 2)
                {
                    scan(std::integral_constant<int, 2>(), first, last);
                }
                else
                {
                    scan(std::integral_constant<int, 3>(), first, last);
                }
            }
        }
    }
}

} // End anonymous namespace

void clusterList::formClusters
(
    const sourceGroup& targets,
    const int width,
    const double longest
)
{
    const particleView& p = targets.particles;

    clusters_.clear();
    int first = 0;
    while (first < p.n)
    {
        box b = boundingBox(p, first, 1);
        int count = 1;
        for (; count < width && first + count < p.n; ++count)
        {
            const int i = first + count;
            box grown = b;
            bool fits = true;
            for (int k = 0; k < p.D; ++k)
            {
                grown.lower[k] = std::min(b.lower[k], p.x[k][i]);
                grown.upper[k] = std::max(b.upper[k], p.x[k][i]);
                fits = fits && grown.upper[k] - grown.lower[k] <= longest;
            }
            if (!fits)
            {
                break;
            }
            b = grown;
        }
        clusters_.push_back({targets.offset + first, count, 0, 0, 0, 0});
        first += count;
    }
}

void clusterList::build
(
    const sourceGroup& targets,
    const int width,
    const double reach,
    const double longest,
    const sourceGroup& fluid,
    const sourceGroup& wall
)
{
    formClusters(targets, width, longest);

    const int nParts = omp_get_max_threads();
    const int nClusters = size();
    parts_.resize(nParts);

    #pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < nParts; ++t)
    {
        std::vector<std::uint32_t>& part = parts_[t];
        part.clear();
        const int last = int(std::int64_t(nClusters)*(t + 1)/nParts);
        for (int c = int(std::int64_t(nClusters)*t/nParts); c < last; ++c)
        {
            cluster& now = clusters_[c];
            now.part = t;
            const box b = boundingBox
            (
                targets.particles, now.first - targets.offset, now.count
            );
            now.begin = part.size();
            listSources(fluid, b, reach, part);
            now.fluidEnd = part.size();
            listSources(wall, b, reach, part);
            now.end = part.size();
        }
    }
}

double clusterList::meanListed() const
{
    double sum = 0;
    double n = 0;
    for (const cluster& c : clusters_)
    {
        sum += double(c.end - c.begin)*c.count;
        n += c.count;
    }
    return n > 0 ? sum/n : 0;
}

std::size_t clusterList::bytes() const
{
    std::size_t n = sizeof(cluster)*clusters_.capacity();
    for (const auto& part : parts_)
    {
        n += sizeof(std::uint32_t)*part.capacity();
    }
    return n;
}

} // End namespace ulph
