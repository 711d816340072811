/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentMatrixFreeSurface.H"
#include "clusterShares.H"
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


void Foam::freeSurfaces::momentMatrixFreeSurface::findHidden
(
    const neighbourSearch& search,
    const ulph::clusterList::cluster& c,
    ulph::laneRow& hidden
) const
{
    const particleField& x = search.cloud().x();
    const scalar h2 = sqr(h_);

    const ulph::clusterList::sources fluid(search.fluidList().fluid(c));
    ulph::laneRow members[3] = {};
    ulph::laneRow normals[3] = {};
    x.load(c.first, c.count, members);
    normal_->load(c.first, c.count, normals);
    for (int l = 0; l < ulph::maxLanes; ++l)
    {
        hidden[l] = l < c.count && doubtful(c.first + l) ? 0 : 1;
    }

    using lanes = ulph::stdx::native_simd<double>;
    constexpr auto aligned = ulph::stdx::element_aligned;
    for (int first = 0; first < c.count; first += int(lanes::size()))
    {
        lanes origin[3];
        lanes normal[3];
        for (int k = 0; k < D_; ++k)
        {
            origin[k] = lanes(members[k] + first, aligned);
            normal[k] = lanes(normals[k] + first, aligned);
        }

        auto found = lanes(hidden + first, aligned) > 0;
        const auto look = [&](const std::uint32_t j)
        {
            lanes r2 = 0;
            lanes along = 0;
            for (int k = 0; k < D_; ++k)
            {
                const lanes d = x.component(k)[j] - origin[k];
                r2 += d*d;
                along += d*normal[k];
            }
            // A cone of 45 degrees, and from sqrt(2) h on the ball of radius h
            // about x_I + h n; the particle itself, along = 0, is in neither
            found = found
             || (
                    along > 0
                 && r2 < 4*h2
                 && (
                        (r2 < 2*h2 && 2*along*along > r2)
                     || (r2 >= 2*h2 && 2*h_*along > r2)
                    )
                );
            return !all_of(found);
        };
        if (!all_of(found))
        {
            fluid.goThrough(look);
        }
        for (int l = 0; l < int(lanes::size()); ++l)
        {
            hidden[first + l] = found[l];
        }
    }
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

    ulph::clusterShares shares(list.size());

    #pragma omp parallel
    for (const int i : shares)
    {
        const ulph::clusterList::cluster& c = list[i];
        ulph::laneRow hidden;
        if (mask_[i])
        {
            findHidden(search, c, hidden);
        }
        for (int l = 0; l < c.count; ++l)
        {
            const label p = c.first + l;
            onSurface_[p] =
                (*lambda_)(p) < surface_ || (mask_[i] && hidden[l] == 0);
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
