/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The weight functions against the literature.

\*---------------------------------------------------------------------------*/

#include "pairRig.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The kernel's integral and its values against the literature
static void kernelCheck
(
    tally& t,
    const std::string& kernel,
    const int D,
    const ulph::pairSums& sums,
    const double h
)
{
    const double pi = 3.14159265358979323846;
    const int n = 20000;
    const std::string what(std::to_string(D) + "D " + kernel);
    double integral = 0;
    deviation error;
    for (int i = 0; i < n; ++i)
    {
        const double r = (i + 0.5)*2*h/n;
        integral +=
            sums.weight(r)*(D == 2 ? 2*pi*r : 4*pi*r*r)*2*h/n;
        error.add(sums.weight(r), literatureKernel(kernel, D, h, r));
    }
    t.check(what + " integral", std::abs(integral - 1), 1e-8);
    t.check(what + " values", error.relative(), 1e-14);
    t.check(what + " beyond 2h", sums.weight(2.001*h), 0.0);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::kernelChecks(tally& t)
{
    const double h = 0.02;
    for (const int D : {2, 3})
    {
        for (const std::string& kernel : ulph::pairSums::kernels())
        {
            kernelCheck
            (
                t, kernel, D, *ulph::pairSums::New(kernel, false, D, 2*h), h
            );
        }
    }
}


// ************************************************************************* //
