/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    momentTensor against Eigen.

\*---------------------------------------------------------------------------*/

#include "particleSample.H"

#include "momentTensor.H"
#include "symmetric.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Eigenvalues that try a closed form: apart, two or all alike or nearly so,
//- rank deficient
static std::vector<vec> spectra(const int D, randomVectors& random)
{
    std::vector<vec> all;
    const auto add = [&](const double a, const double b, const double c)
    {
        all.push_back(vec(a, b, D == 3 ? c : 0));
    };
    for (int i = 0; i < 200; ++i)
    {
        const double a = random.number(0.01, 2);
        const double b = random.number(0.01, 2);
        const double c = random.number(0.01, 2);
        const double tiny = std::pow(10, random.number(-16, -2));
        add(a, b, c);
        add(a, a, b);
        add(a, b, b);
        add(a, a*(1 + tiny), b);
        add(b, a, a*(1 + tiny));
        add(a, a*(1 + tiny), a*(1 - tiny));
        add(a, a, a);
        add(tiny, a, b);
        add(tiny, tiny, a);
        add(0, a, b);
        add(0, 0, a);
    }
    add(0, 0, 0);
    return all;
}


static void tensorChecks(tally& t, const int D)
{
    randomVectors random(D, 5);

    double smallest = 0;
    double floored = 0;
    deviation product, inverse, divergence;
    int nMinors = 0;
    int nWrongMinors = 0;

    for (const vec& spectrum : spectra(D, random))
    {
        const mat R(random.rotation());
        const mat A(R*spectrum.asDiagonal()*R.transpose());
        const double size = std::max(spectrum.maxCoeff(), 1e-300);

        // Neither the first lane nor the first register, so that a mix-up shows
        constexpr int lane = 11;
        constexpr int count = 13;
        ulph::laneRow M[6] = {};
        for (int i = 0; i < D; ++i)
        {
            for (int j = i; j < D; ++j)
            {
                M[ulph::symmetricIndex(D, i, j)][lane] = A(i, j);
            }
        }
        const auto result = [&](const ulph::laneRow* K)
        {
            mat B(mat::Zero());
            for (int i = 0; i < D; ++i)
            {
                for (int j = 0; j < D; ++j)
                {
                    B(i, j) = K[ulph::symmetricIndex(D, i, j)][lane];
                }
            }
            return B;
        };

        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen
        (
            A.topLeftCorner(D, D)
        );
        ulph::laneRow lambda;
        momentTensor::smallestEigenvalue(D, count, M, lambda);
        smallest = std::max
        (
            smallest, std::abs(lambda[lane] - eigen.eigenvalues()[0])/size
        );

        ulph::laneRow K[6] = {};
        const double floor = 0.36;
        momentTensor::flooredInverse(D, lane, M, floor, K);
        mat exact(mat::Zero());
        exact.topLeftCorner(D, D) =
            eigen.eigenvectors()
           *eigen.eigenvalues().cwiseMax(floor).cwiseInverse().asDiagonal()
           *eigen.eigenvectors().transpose();
        floored = std::max
        (
            floored, (result(K) - exact).norm()/exact.norm()
        );

        ulph::laneRow minor;
        for (const double factor : {0.5, 0.999, 1.001, 2.0})
        {
            const double shift = factor*eigen.eigenvalues()[0];
            momentTensor::leastMinor(D, count, M, shift, minor);
            if (shift > 1e-6*size)
            {
                ++nMinors;
                nWrongMinors += (minor[lane] > 0) != (factor < 1);
            }
        }

        ulph::laneRow determinant;
        momentTensor::adjugate(D, count, M, K, determinant);
        const double conditioned = eigen.eigenvalues()[0]/size;
        if (conditioned > 0.01)
        {
            mat B(mat::Zero());
            B.topLeftCorner(D, D) = A.topLeftCorner(D, D).inverse();
            inverse.add(mat(result(K)/determinant[lane]*size), mat(B*size));
        }

        ulph::laneRow a[3] = {};
        ulph::laneRow Ma[3];
        const vec b(random.vector(1));
        for (int k = 0; k < D; ++k)
        {
            a[k][lane] = b[k];
        }
        momentTensor::multiply(D, count, M, a, Ma);
        product.add
        (
            vec(Ma[0][lane], Ma[1][lane], D == 3 ? Ma[2][lane] : 0), vec(A*b)
        );

        const mat W(random.rotation() - mat(mat::Identity()));
        mat B(mat::Zero());
        ulph::laneRow L[9] = {};
        scalar turning[9];
        for (int k = 0; k < D; ++k)
        {
            const vec row(random.vector(1));
            for (int m = 0; m < D; ++m)
            {
                B(k, m) = L[k*D + m][lane] = row[m];
                turning[k*D + m] = W(k, m);
            }
        }
        ulph::laneRow div;
        ulph::laneRow ahead;
        std::fill_n(ahead, ulph::maxLanes, 0.3);
        momentTensor::divergence(D, count, M, L, ahead, turning, div);
        const mat G(B*A);
        divergence.add(div[lane], (G + 0.3*G*(G + W)).trace());
    }

    const std::string what(std::to_string(D) + "D momentTensor ");
    t.check(what + "smallest eigenvalue over the largest", smallest, 1e-13);
    t.check(what + "floored inverse", floored, 1e-12);
    t.check(what + "inverse by adjugate", inverse.relative(), 1e-12);
    t.check(what + "product", product.relative(), 1e-15);
    t.check(what + "divergence", divergence.relative(), 1e-15);
    t.check(what + "minors of the wrong sign", nWrongMinors, 0.0);
    t.check(what + "minors", nMinors > 20);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::tensorChecks(tally& t)
{
    tensorChecks(t, 2);
    tensorChecks(t, 3);
}


// ************************************************************************* //
