// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellLayout.H"

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
    inverseSize_(1/size),
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

    for (int k = 0; k < D; ++k)
    {
        extent_[k] = int(count(k));
    }
}

std::vector<int> cellLayout::hilbertCurve() const
{
    int bits = 1;
    while ((1 << bits) < *std::max_element(extent_.begin(), extent_.end()))
    {
        ++bits;
    }

    std::vector<std::uint64_t> key(nCells());
    for (int c = 0; c < nCells(); ++c)
    {
        const std::array<int, 3> at(coordinates(c));
        key[c] = hilbertIndex
        (
            {
                std::uint32_t(at[0]), std::uint32_t(at[1]), std::uint32_t(at[2])
            },
            D_,
            bits
        );
    }

    std::vector<int> along(key.size());
    std::iota(along.begin(), along.end(), 0);
    std::sort
    (
        along.begin(), along.end(),
        [&](const int a, const int b) { return key[a] < key[b]; }
    );
    return along;
}

} // End namespace ulph
