/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentMatrixFreeSurface.H"
#include "momentTensor.H"
#include "neighbourSearch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::freeSurfaces::momentMatrixFreeSurface::doubtful(const label i) const
{
    const scalar lambda = (*lambda_)(i);
    return lambda >= surface_ && lambda <= interior_;
}


void Foam::freeSurfaces::momentMatrixFreeSurface::normals(neighbourSearch& search)
{
    class sink
    :
        public ulph::sumSink<ulph::geometryBlock>
    {
        const int D_;
        const scalar small_;
        particleField& normal_;

    public:

        sink(const int D, const scalar beta, particleField& normal)
        :
            D_(D),
            small_(1e-3*std::pow(beta, D)),
            normal_(normal)
        {}

        void take(const ulph::geometryBlock& sums) override
        {
            ulph::laneRow adj[6];
            ulph::laneRow determinant;
            ulph::laneRow n[3];
            momentTensor::adjugate
            (
                D_, sums.count, sums.M, adj, determinant
            );
            momentTensor::multiply(D_, sums.count, adj, sums.G, n);

            for (int l = 0; l < sums.count; ++l)
            {
                // Too thin for an inverse: the bare sum has the direction
                const bool poor = determinant[l] < small_;
                scalar length2 = VSMALL;
                for (int k = 0; k < D_; ++k)
                {
                    n[k][l] = poor ? -sums.G[k][l] : -n[k][l];
                    length2 += sqr(n[k][l]);
                }
                for (int k = 0; k < D_; ++k)
                {
                    n[k][l] /= std::sqrt(length2);
                }
            }
            normal_.store(sums.first, sums.count, n);
        }
    };

    search.halo().copy(*lambda_);
    forTiles(lambda_->size(), [&](const label first, const label count)
    {
        ulph::laneRow lambda;
        lambda_->load(0, first, count, lambda);
        search.sums().packScalar(first, count, lambda);
    });

    ulph::passRange range;
    range.mask = mask_.data();
    range.fluidOnly = true;
    sink normals(D_, search.cloud().shared().beta, *normal_);
    search.sums().geometry
    (
        search.fluidList(),
        range,
        ulph::momentSums | ulph::gradientSums,
        normals
    );
}


bool Foam::freeSurfaces::momentMatrixFreeSurface::umbrellaEmpty
(
    const neighbourSearch& search,
    const ulph::clusterList::cluster& c,
    const label i
) const
{
    const particleField& x = search.cloud().x();
    const std::uint32_t* const neighbours =
        search.fluidList().neighbours(c);

    for (std::size_t j = c.begin; j < c.fluidEnd; ++j)
    {
        const label J = label(neighbours[j]);
        scalar r2 = 0;
        scalar along = 0;
        for (int k = 0; k < D_; ++k)
        {
            const scalar d = x.component(k)[J] - x.component(k)[i];
            r2 += sqr(d);
            along += d*(*normal_)(i, k);
        }
        if (J == i || along <= 0 || r2 >= sqr(2*h_))
        {
            continue;
        }
        if (r2 >= 2*sqr(h_))
        {
            // |x_J - S|^2 with S = x_I + h n
            if (r2 - 2*h_*along + sqr(h_) < sqr(h_))
            {
                return false;
            }
        }
        else if (2*sqr(along) > r2)
        {
            return false;
        }
    }
    return true;
}


void Foam::freeSurfaces::momentMatrixFreeSurface::markSurface
(
    neighbourSearch& search
)
{
    const ulph::clusterList& list = search.fluidList();

    mask_.resize(list.size());

    #pragma omp parallel for schedule(static)
    for (int i = 0; i < list.size(); ++i)
    {
        const ulph::clusterList::cluster& c = list[i];
        mask_[i] = 0;
        for (int p = c.first; p < c.first + c.count; ++p)
        {
            mask_[i] |= doubtful(p);
        }
    }
    normal_->reset(lambda_->size());
    normals(search);
    known_ = mask_;

    onSurface_.resize(lambda_->size());

    #pragma omp parallel for schedule(dynamic, 16)
    for (int i = 0; i < list.size(); ++i)
    {
        const ulph::clusterList::cluster& c = list[i];
        for (int p = c.first; p < c.first + c.count; ++p)
        {
            onSurface_[p] =
                (*lambda_)(p) < surface_
             || (doubtful(p) && umbrellaEmpty(search, c, p));
        }
    }
    search.halo().copy(onSurface_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::freeSurfaces::momentMatrixFreeSurface::detect(neighbourSearch& search)
{
    markSurface(search);
    markVicinity(search);
    normals(search);
}


// ************************************************************************* //
