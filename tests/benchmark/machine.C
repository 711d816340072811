/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What one core can do: fused multiply-adds in registers, float and double
    [GFLOP/s], and the triad a = b + s c on arrays larger than the cache
    [GB/s]. Best of several short measurements in CPU time.

\*---------------------------------------------------------------------------*/

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

static double seconds()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}

#ifdef __AVX512F__
constexpr int registerBytes = 64;
#elif defined(__AVX__)
constexpr int registerBytes = 32;
#else
constexpr int registerBytes = 16;
#endif

template<class Real>
static double fma()
{
    typedef Real lanes __attribute__((vector_size(registerBytes)));
    constexpr int width = registerBytes/sizeof(Real);
    constexpr int chains = 12;
    constexpr int steps = 2000000;

    double best = 0;
    for (int repeat = 0; repeat < 7; ++repeat)
    {
        lanes sum[chains] = {};
        lanes factor = lanes{} + Real(0.5);
        for (lanes& s : sum)
        {
            // Else the compiler sees that the chains are all the same
            asm volatile("" : "+x"(s));
        }
        const double start = seconds();
        for (int i = 0; i < steps; ++i)
        {
            asm volatile("" : "+x"(factor));
            #pragma GCC unroll 12
            for (int c = 0; c < chains; ++c)
            {
                sum[c] = sum[c]*factor + factor;
            }
        }
        const double time = seconds() - start;
        for (lanes& s : sum)
        {
            asm volatile("" : "+x"(s));
        }
        best = std::max(best, 2.0*width*chains*steps/time/1e9);
    }
    return best;
}

static double triad()
{
    const std::size_t n = 8000000;
    std::vector<double> a(n, 1), b(n, 2), c(n, 3);

    double best = 0;
    for (int repeat = 0; repeat < 7; ++repeat)
    {
        const double start = seconds();
        for (std::size_t i = 0; i < n; ++i)
        {
            a[i] = b[i] + 0.5*c[i];
        }
        asm volatile("" : : "r"(a.data()) : "memory");
        best = std::max(best, 3*sizeof(double)*n/(seconds() - start)/1e9);
    }
    return best;
}

int main()
{
    std::printf("%.1f %.1f %.1f\n", fma<float>(), fma<double>(), triad());
}


// ************************************************************************* //
