// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellGrid.H"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace ulph
{

namespace
{

// Index along the Hilbert curve of b bits per direction: Skilling's transform
// (AIP Conf. Proc. 707, 2004) of the coordinates, then interleaved bits
std::uint64_t hilbertIndex(std::array<std::uint32_t, 3> x, int D, int b)
{
    for (std::uint32_t q = 1u << (b - 1); q > 1; q >>= 1)
    {
        const std::uint32_t p = q - 1;
        for (int i = 0; i < D; ++i)
        {
            if (x[i] & q)
            {
                x[0] ^= p;
            }
            else
            {
                const std::uint32_t t = (x[0] ^ x[i]) & p;
                x[0] ^= t;
                x[i] ^= t;
            }
        }
    }

    for (int i = 1; i < D; ++i)
    {
        x[i] ^= x[i - 1];
    }
    std::uint32_t t = 0;
    for (std::uint32_t q = 1u << (b - 1); q > 1; q >>= 1)
    {
        if (x[D - 1] & q)
        {
            t ^= q - 1;
        }
    }

    std::uint64_t index = 0;
    for (int bit = b - 1; bit >= 0; --bit)
    {
        for (int i = 0; i < D; ++i)
        {
            index = index << 1 | ((x[i] ^ t) >> bit & 1u);
        }
    }
    return index;
}

} // End anonymous namespace

cellLayout::cellLayout
(
    const int D,
    const std::array<double, 3>& lower,
    const std::array<double, 3>& upper,
    const double size
)
:
    D_(D),
    size_(size),
    lower_(lower),
    extent_{1, 1, 1}
{
    constexpr double largestTable = (1 << 30)/10/sizeof(int);

    const auto count = [&](const int k)
    {
        return std::max(1.0, std::ceil((upper[k] - lower[k])/size_));
    };

    double cells = 0;
    do
    {
        cells = 1;
        for (int k = 0; k < D; ++k)
        {
            cells *= count(k);
        }
        size_ *= cells > largestTable ? 2 : 1;
    } while (cells > largestTable);

    int bits = 1;
    for (int k = 0; k < D; ++k)
    {
        extent_[k] = int(count(k));
        while ((1 << bits) < extent_[k])
        {
            ++bits;
        }
    }

    std::vector<std::uint64_t> key(static_cast<std::size_t>(cells));
    std::size_t c = 0;
    for (int k = 0; k < extent_[2]; ++k)
    {
        for (int j = 0; j < extent_[1]; ++j)
        {
            for (int i = 0; i < extent_[0]; ++i)
            {
                key[c++] = hilbertIndex
                (
                    {std::uint32_t(i), std::uint32_t(j), std::uint32_t(k)},
                    D,
                    bits
                );
            }
        }
    }

    std::vector<int> byKey(key.size());
    std::iota(byKey.begin(), byKey.end(), 0);
    std::sort
    (
        byKey.begin(), byKey.end(),
        [&](const int a, const int b) { return key[a] < key[b]; }
    );

    rank_.resize(key.size());
    for (std::size_t i = 0; i < byKey.size(); ++i)
    {
        rank_[byKey[i]] = int(i);
    }
}

std::vector<int> cellGrid::sort(const particleView& particles)
{
    const cellLayout& cells = *layout_;
    const int n = particles.n;

    std::vector<int> rankOf(n);
    #pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i)
    {
        std::array<int, 3> c{};
        for (int k = 0; k < cells.D(); ++k)
        {
            c[k] = cells.coordinate(k, particles.x[k][i]);
        }
        rankOf[i] = cells.rank(c[0], c[1], c[2]);
    }

    first_.assign(cells.nCells() + 1, 0);
    for (int i = 0; i < n; ++i)
    {
        ++first_[rankOf[i] + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());

    std::vector<int> order(n);
    for (int i = 0; i < n; ++i)
    {
        order[first_[rankOf[i]]++] = i;
    }
    // Filling has moved every start to the next one
    std::copy_backward(first_.begin(), first_.end() - 1, first_.end());
    first_.front() = 0;

    return order;
}

} // End namespace ulph
