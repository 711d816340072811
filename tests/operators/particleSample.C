/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleSample.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vec Foam::randomVectors::vector(const double size)
{
    vec a(vec::Zero());
    for (int k = 0; k < D_; ++k)
    {
        a[k] = number(-size, size);
    }
    return a;
}


Foam::mat Foam::randomVectors::rotation()
{
    mat R(mat::Identity());
    for (int i = 0; i < D_; ++i)
    {
        for (int j = i + 1; j < D_; ++j)
        {
            const double angle = number(0.3, 1.2);
            mat turn(mat::Identity());
            turn(i, i) = turn(j, j) = std::cos(angle);
            turn(j, i) = std::sin(angle);
            turn(i, j) = -turn(j, i);
            R = turn*R;
        }
    }
    return R;
}


Foam::mat Foam::randomVectors::definite(const double lower, const double upper)
{
    const mat R(rotation());
    vec eigenvalues(vec::Zero());
    for (int k = 0; k < D_; ++k)
    {
        eigenvalues[k] = number(lower, upper);
    }
    return R*eigenvalues.asDiagonal()*R.transpose();
}


void Foam::particleSample::add(const vec& position, randomVectors& random)
{
    x.push_back(position);
    v.push_back(random.vector(1));
    g.push_back(random.vector(1));
    V.push_back(std::pow(dx, D)*random.number(0.8, 1.2));
    s.push_back(random.number(-1, 1));
    p.push_back(random.number(-1, 1));
    K.push_back(random.definite(0.5, 2)/(dx*dx));
}


void Foam::particleSample::permute(const ulph::particleOrder& order)
{
    ulph::permute(x.data(), order);
    ulph::permute(v.data(), order);
    ulph::permute(g.data(), order);
    ulph::permute(V.data(), order);
    ulph::permute(s.data(), order);
    ulph::permute(p.data(), order);
    ulph::permute(K.data(), order);
}


Foam::particleSample Foam::particleSample::block(const int D)
{
    particleSample sample;
    sample.D = D;
    sample.dx = 0.01;

    const double n = (D == 2 ? 30 : 10)*sample.dx;
    const double layer = 5*sample.dx;
    const int last = D - 1;

    vec lower(vec::Zero());
    vec upper(vec::Zero());
    upper.head(D).setConstant(n);

    randomVectors random(D, 2);
    for (const vec& x : jitteredLattice(D, sample.dx, lower, upper, 0.25))
    {
        sample.add(x, random);
    }
    sample.nFluid = sample.size();

    lower[last] = -layer;
    upper[last] = 0;
    for (const vec& x : jitteredLattice(D, sample.dx, lower, upper, 0.25, 3))
    {
        sample.add(x, random);
    }
    return sample;
}


Foam::particleSample Foam::particleSample::spray(const int D)
{
    particleSample sample;
    sample.D = D;
    sample.dx = 0.01;

    randomVectors random(D, 4);
    vec edge(vec::Zero());
    edge.head(D).setConstant(2*sample.dx);
    for (int i = 0; i < 200; ++i)
    {
        const vec x(random.vector(D == 2 ? 1 : 0.3));
        if (i % 3)
        {
            sample.add(x, random);
            continue;
        }
        for (const vec& drop : jitteredLattice(D, sample.dx, x, x + edge, 0.3))
        {
            sample.add(drop, random);
        }
    }
    sample.nFluid = sample.size();
    return sample;
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<Foam::vec> Foam::jitteredLattice
(
    const int D,
    const double dx,
    const vec& lower,
    const vec& upper,
    const double jitter,
    const unsigned seed
)
{
    randomVectors random(D, seed);

    int n[3] = {1, 1, 1};
    for (int k = 0; k < D; ++k)
    {
        n[k] = int(std::round((upper[k] - lower[k])/dx));
    }

    std::vector<vec> points;
    for (int k = 0; k < n[2]; ++k)
    {
        for (int j = 0; j < n[1]; ++j)
        {
            for (int i = 0; i < n[0]; ++i)
            {
                vec x((i + 0.5)*dx, (j + 0.5)*dx, D == 3 ? (k + 0.5)*dx : 0);
                points.push_back(lower + x + random.vector(jitter*dx));
            }
        }
    }
    return points;
}


// ************************************************************************* //
