/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pairRig.H"

// * * * * * * * * * * * * * * * Global Data * * * * * * * * * * * * * * * * //

namespace Foam
{

const std::vector<sumGroup> geometryGroups
{
    {"M", ulph::momentSums, 0, {3, 6}},
    {"b", ulph::momentSums, 6, {2, 3}},
    {"G", ulph::gradientSums, 9, {2, 3}},
    {"Q", ulph::laplacianSums, 12, {3, 6}},
    {"L", ulph::velocityGradientSums, 18, {4, 9}},
    {"n", ulph::spacingSums, 27, {1, 1}},
    {"d", ulph::spacingSums, 28, {1, 1}},
    {"e", ulph::spacingSums, 29, {2, 3}}
};

const std::vector<sumGroup> forceGroups
{
    {"pressure", ulph::pressureSums, 0, {2, 3}},
    {"H", ulph::densityDiffusionSums, 3, {4, 9}},
    {"A", ulph::viscousSums, 12, {2, 3}},
    {"symmetricA", ulph::symmetricViscousSums, 15, {2, 3}},
    {"b", ulph::divergenceSums, 18, {2, 3}},
    {"L", ulph::divergenceSums, 21, {4, 9}}
};

const std::vector<sumGroup> interpolationGroups
{
    {"w", 0, 0, {1, 1}},
    {"wx", 0, 1, {2, 3}},
    {"ws", ulph::scalarAverages, 4, {1, 1}},
    {"wsx", ulph::scalarAverages, 5, {2, 3}},
    {"wv", ulph::velocityAverages, 8, {2, 3}}
};


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void addTo
(
    std::vector<double>& row,
    const int first,
    const int D,
    const vec& a
)
{
    for (int k = 0; k < D; ++k)
    {
        row[first + k] += a[k];
    }
}


static void addTo
(
    std::vector<double>& row,
    const int first,
    const int D,
    const mat& A,
    const bool symmetric
)
{
    for (int k = 0; k < D; ++k)
    {
        for (int l = symmetric ? k : 0; l < D; ++l)
        {
            const int c = symmetric ? ulph::symmetricIndex(D, k, l) : k*D + l;
            row[first + c] += A(k, l);
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bruteSums::bruteSums
(
    const particleSample& sample,
    const std::string& kernel,
    const double h
)
:
    sample_(sample),
    kernel_(kernel),
    h_(h)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Body>
void Foam::bruteSums::forPairs
(
    const int i,
    const int first,
    const int last,
    const Body& body
) const
{
    for (int j = first; j < last; ++j)
    {
        const vec x(sample_.x[j] - sample_.x[i]);
        const double r = x.norm();
        if (j != i && r < 2*h_)
        {
            body(j, x, r, literatureKernel(kernel_, sample_.D, h_, r));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::sumRows Foam::bruteSums::geometry(const int last) const
{
    const particleSample& s = sample_;
    const int D = s.D;

    sumRows rows(s.nFluid, std::vector<double>(32, 0));
    for (int i = 0; i < s.nFluid; ++i)
    {
        std::vector<double>& row = rows[i];
        forPairs(i, 0, last, [&](int j, const vec& x, double r, double w)
        {
            const double wV = w*s.V[j];
            const double ds = s.s[j] - s.s[i];
            const mat xx(x*x.transpose());

            addTo(row, 0, D, mat(wV*xx), true);
            addTo(row, 6, D, vec(wV*x));
            addTo(row, 9, D, vec(wV*ds*x));
            addTo(row, 12, D, mat(wV*ds/(r*r)*xx), true);
            addTo(row, 18, D, mat(wV*(s.v[j] - s.v[i])*x.transpose()), false);
            row[27] += 1;
            row[28] += r;
            addTo(row, 29, D, vec(x/(r*r*r)));
        });
    }
    return rows;
}


Foam::sumRows Foam::bruteSums::force(const int last, const double eta2) const
{
    const particleSample& s = sample_;
    const int D = s.D;

    sumRows rows(s.nFluid, std::vector<double>(30, 0));
    for (int i = 0; i < s.nFluid; ++i)
    {
        std::vector<double>& row = rows[i];
        forPairs(i, 0, last, [&](int j, const vec& x, double r, double w)
        {
            const double wV = w*s.V[j];
            const double pi = (s.v[j] - s.v[i]).dot(x)/(r*r + eta2);

            addTo(row, 0, D, vec(wV*s.p[j]*s.K[j]*x));
            addTo(row, 3, D, mat(wV*s.g[j]*x.transpose()), false);
            addTo(row, 12, D, vec(wV*pi*x));
            addTo(row, 15, D, vec(wV*pi*s.K[j]*x));
            addTo(row, 18, D, vec(wV*x));
            addTo(row, 21, D, mat(wV*(s.v[j] - s.v[i])*x.transpose()), false);
        });
    }
    return rows;
}


Foam::sumRows Foam::bruteSums::interpolation() const
{
    const particleSample& s = sample_;
    const int D = s.D;

    // The library leaves the kernel's norm out of what becomes an average
    const double norm =
        literatureKernel(kernel_, D, h_, 0)/(kernel_ == "WendlandC4" ? 3 : 1);

    sumRows rows(s.size() - s.nFluid, std::vector<double>(11, 0));
    for (int i = s.nFluid; i < s.size(); ++i)
    {
        std::vector<double>& row = rows[i - s.nFluid];
        forPairs(i, 0, s.nFluid, [&](int j, const vec& x, double, double wJ)
        {
            const double w = wJ/norm;
            row[0] += w;
            addTo(row, 1, D, vec(w*x));
            row[4] += w*s.s[j];
            addTo(row, 5, D, vec(w*s.s[j]*x));
            addTo(row, 8, D, vec(w*s.v[j]));
        });
    }
    return rows;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

double Foam::literatureKernel
(
    const std::string& kernel,
    const int D,
    const double h,
    const double r
)
{
    const double pi = 3.14159265358979323846;
    const double q = r/h;
    const double a = 1 - 0.5*q;
    const double perVolume = std::pow(h, -D)/pi;
    if (q >= 2)
    {
        return 0;
    }
    if (kernel == "WendlandC2")
    {
        return
            (D == 2 ? 7.0/4 : 21.0/16)*perVolume*std::pow(a, 4)*(1 + 2*q);
    }
    return
        (D == 2 ? 9.0/4 : 495.0/256)*perVolume*std::pow(a, 6)
       *(1 + 3*q + 35.0/12*q*q);
}


// ************************************************************************* //
