/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "haloParticles.H"
#include "fvMesh.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::haloParticles::findShown(const scalar width)
{
    std::vector<vector> translations(cyclic_.translations());
    translations.insert(translations.begin(), vector(Zero));

    shown_.clear();
    labelList sent(UPstream::nProcs(), 0);
    forAll(sent, rank)
    {
        // Fluid of the rank, and what it sees around
        boundBox sees(decomposition_.box(rank));
        const boundBox& mesh = cloud_.mesh().bounds();
        sees.min() = max(sees.min(), mesh.min()) - vector::uniform(width);
        sees.max() = min(sees.max(), mesh.max()) + vector::uniform(width);

        for (label i = 0; i < cloud_.size(); ++i)
        {
            const point p(cloud_.position(i));
            for (const vector& translation : translations)
            {
                const bool itself =
                    rank == UPstream::myProcNo() && translation == vector(Zero);
                if (!itself && sees.contains(p + translation))
                {
                    shown_.push_back({i, translation});
                    ++sent[rank];
                }
            }
        }
    }
    ways_ = rankExchange(sent);
}


Foam::scalar Foam::haloParticles::place(const image& shown, const int k) const
{
    return cloud_.x()(shown.source, k) + shown.translation[cloud_.axis(k)];
}


void Foam::haloParticles::store
(
    const std::vector<scalar>& fetched,
    particleField& field
) const
{
    const label n = label(order_.size());
    const int nComponents = field.nComponents();

    #pragma omp parallel for schedule(static)
    for (label i = 0; i < n; ++i)
    {
        for (int c = 0; c < nComponents; ++c)
        {
            field.set
            (
                cloud_.size() + i, c,
                fetched[std::size_t(order_[i])*nComponents + c]
            );
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::haloParticles::haloParticles
(
    ulphCloud& cloud,
    std::shared_ptr<const ulph::cellCurve> curve
)
:
    cloud_(cloud),
    cyclic_(cloud.mesh()),
    clusters_(std::move(curve))
{
    cyclic_.warnOfMisfit(cloud.dx());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::haloParticles::strayed(const scalar farthest) const
{
    if (!cyclic_.any())
    {
        return false;
    }
    bool any = false;

    #pragma omp parallel for schedule(static) reduction(|| : any)
    for (label i = 0; i < cloud_.size(); ++i)
    {
        any = any || cyclic_.past(cloud_.position(i)) > farthest;
    }
    return returnReduce(any, orOp<bool>());
}


bool Foam::haloParticles::wrap()
{
    if (!cyclic_.any())
    {
        return false;
    }
    bool any = false;

    #pragma omp parallel for schedule(static) reduction(|| : any)
    for (label i = 0; i < cloud_.size(); ++i)
    {
        const point p(cloud_.position(i));
        if (cyclic_.past(p) > 0)
        {
            cloud_.translate(i, cyclic_.wrapped(p) - p);
            any = true;
        }
    }
    return returnReduce(any, orOp<bool>());
}


void Foam::haloParticles::make(const scalar width, const int clusterWidth)
{
    if (!any())
    {
        return;
    }
    cyclic_.checkPeriods(width);
    findShown(width);

    const int D = cloud_.D();
    const std::vector<scalar> fetched(fetch(D, [&](const image& shown, const label k)
    {
        return place(shown, k);
    }));
    const int n = int(fetched.size())/D;

    std::array<std::vector<double>, 3> x;
    ulph::particleView view;
    view.D = D;
    view.n = n;
    for (int k = 0; k < D; ++k)
    {
        x[k].resize(n);
        for (int i = 0; i < n; ++i)
        {
            x[k][i] = fetched[std::size_t(i)*D + k];
        }
        view.x[k] = x[k].data();
    }
    const ulph::particleOrder order(clusters_.sort(view, clusterWidth));
    order_.assign(order.begin(), order.end());
    cloud_.setHalo(n);
    copyPositions();
    copy(cloud_.mass());
}


void Foam::haloParticles::copyPositions()
{
    if (!any())
    {
        return;
    }
    const int D = cloud_.D();
    const std::vector<scalar> fetched(fetch(D, [&](const image& shown, const label k)
    {
        return place(shown, k);
    }));
    store(fetched, cloud_.x());
}


void Foam::haloParticles::copy(particleField& field) const
{
    if (!any())
    {
        return;
    }
    const std::vector<scalar> fetched
    (
        fetch(field.nComponents(), [&](const image& shown, const label c)
        {
            return field(shown.source, c);
        })
    );
    store(fetched, field);
}


void Foam::haloParticles::markSources(std::vector<unsigned char>& marks) const
{
    if (!any())
    {
        return;
    }
    std::vector<scalar> asCame(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i)
    {
        asCame[order_[i]] = marks[cloud_.size() + i];
    }
    const std::vector<scalar> ofShown(ways_.back(asCame, 1));
    for (std::size_t i = 0; i < shown_.size(); ++i)
    {
        marks[shown_[i].source] |= ofShown[i] > 0;
    }
}


// ************************************************************************* //
