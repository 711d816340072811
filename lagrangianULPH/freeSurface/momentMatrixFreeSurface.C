/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentMatrixFreeSurface.H"
#include "addToRunTimeSelectionTable.H"
#include "momentTensor.H"
#include "neighbourSearch.H"
#include "inputChecks.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace freeSurfaces
{
    defineTypeNameAndDebug(momentMatrixFreeSurface, 0);
    addToRunTimeSelectionTable(freeSurface, momentMatrixFreeSurface, dictionary);
}
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::freeSurfaces::momentMatrixFreeSurface::threshold
(
    const dictionary& dict,
    const word& name,
    const scalar fraction,
    const ulphCloud& cloud
) const
{
    const scalar hByDx = cloud.h()/cloud.dx();
    if (!dict.found(name) && (hByDx < 1.49 || hByDx > 2.51))
    {
        FatalIOErrorInFunction(entryPlace(dict.parent(), "hByDx"))
            << "No threshold of lambda is known for h/dx = " << hByDx
            << ", only for 1.5 to 2.5." << nl
            << "    Set hByDx to 2, or give freeSurface { type momentMatrix; "
            << "surface ...; interior ...; }" << nl
            << "    as fractions of the lattice value of lambda, "
            << cloud.shared().beta/sqr(cloud.dx()) << " here."
            << exit(FatalIOError);
    }
    return
        getInRange(dict, name, fraction, scalarMinMax(0, 1))
       *cloud.shared().beta/sqr(cloud.dx());
}


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
}


void Foam::freeSurfaces::momentMatrixFreeSurface::markVicinity
(
    const neighbourSearch& search
)
{
    const ulph::clusterList& list = search.fluidList();
    const particleField& x = search.cloud().x();

    class_->reset(lambda_->size());

    #pragma omp parallel for schedule(dynamic, 16)
    for (int i = 0; i < list.size(); ++i)
    {
        const ulph::clusterList::cluster& c = list[i];
        const std::uint32_t* const first = list.neighbours(c) + c.begin;
        const std::uint32_t* const last = list.neighbours(c) + c.fluidEnd;

        // Members that have seen a surface particle, and any fluid, in reach
        ulph::laneRow sawSurface = {};
        ulph::laneRow sawFluid = {};
        ulph::laneRow members[3];
        for (int k = 0; k < D_; ++k)
        {
            x.load(k, c.first, c.count, members[k]);
        }
        const auto look = [&](const std::uint32_t j, ulph::laneRow& saw)
        {
            ulph::laneRow r2 = {};
            for (int k = 0; k < D_; ++k)
            {
                const scalar xj = x.component(k)[j];
                for (int l = 0; l < c.count; ++l)
                {
                    r2[l] += sqr(xj - members[k][l]);
                }
            }
            for (int l = 0; l < c.count; ++l)
            {
                const bool in = r2[l] < sqr(2*h_) && label(j) != c.first + l;
                saw[l] = in ? 1 : saw[l];
            }
        };

        bool any = false;
        for (const std::uint32_t* j = first; j != last; ++j)
        {
            if (onSurface_[*j])
            {
                any = true;
                look(*j, sawSurface);
            }
        }
        mask_[i] = any && !known_[i];

        const unsigned char* const on = onSurface_.data() + c.first;
        if (std::find(on, on + c.count, 1) != on + c.count)
        {
            const auto lonely = [&]()
            {
                bool found = false;
                for (int l = 0; l < c.count; ++l)
                {
                    found = found || (on[l] && sawFluid[l] == 0);
                }
                return found;
            };
            // Members of a cluster are close to each other, as a rule
            for (int l = 0; l < c.count; ++l)
            {
                look(std::uint32_t(c.first + l), sawFluid);
            }
            for (const std::uint32_t* j = first; j != last && lonely(); ++j)
            {
                look(*j, sawFluid);
            }
        }

        ulph::laneRow classes;
        for (int l = 0; l < c.count; ++l)
        {
            classes[l] =
                on[l] ? (sawFluid[l] > 0 ? surface : splash)
              : sawSurface[l] > 0 ? vicinity : interior;
        }
        class_->store(0, c.first, c.count, classes);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::freeSurfaces::momentMatrixFreeSurface::momentMatrixFreeSurface
(
    const dictionary& dict,
    const ulphCloud& cloud
)
:
    D_(cloud.D()),
    h_(cloud.h()),
    dx_(cloud.dx()),
    surface_(threshold(dict, "surface", surfaceFraction, cloud)),
    interior_(threshold(dict, "interior", interiorFraction, cloud))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::effectNeeds Foam::freeSurfaces::momentMatrixFreeSurface::needs() const
{
    effectNeeds all;
    all.fields.set("lambda", 1);
    all.fields.set("surface", 1);
    all.fields.set("normal", D_);
    all.geometry = ulph::momentSums;
    return all;
}


void Foam::freeSurfaces::momentMatrixFreeSurface::bind(ulphCloud& cloud)
{
    lambda_ = cloud.derived("lambda");
    class_ = cloud.derived("surface");
    normal_ = cloud.derived("normal");
}


void Foam::freeSurfaces::momentMatrixFreeSurface::eigenvalue
(
    const ulph::geometryBlock& sums,
    ulph::laneRow& lambda
) const
{
    momentTensor::smallestEigenvalue(D_, sums.count, sums.M, lambda);
    for (int l = 0; l < sums.count; ++l)
    {
        lambda[l] /= sqr(dx_);
    }
}


void Foam::freeSurfaces::momentMatrixFreeSurface::detect(neighbourSearch& search)
{
    markSurface(search);
    markVicinity(search);
    normals(search);
}


void Foam::freeSurfaces::momentMatrixFreeSurface::release
(
    const label first,
    const label count,
    double* densityExcess
) const
{
    ulph::laneRow surface;
    class_->load(0, first, count, surface);

    label nReleased = 0;
    for (label l = 0; l < count; ++l)
    {
        if (surface[l] == splash && densityExcess[l] != 0)
        {
            densityExcess[l] = 0;
            ++nReleased;
        }
    }
    if (nReleased)
    {
        #pragma omp atomic
        nReleased_ += nReleased;
    }
}


void Foam::freeSurfaces::momentMatrixFreeSurface::keepInside
(
    const label first,
    const label count,
    ulph::laneRow& values
) const
{
    ulph::laneRow surface;
    class_->load(0, first, count, surface);
    for (label l = 0; l < count; ++l)
    {
        values[l] = surface[l] == interior ? values[l] : 0;
    }
}


void Foam::freeSurfaces::momentMatrixFreeSurface::report(Ostream& os) const
{
    os  << "    freeSurface: pressure of a splash particle set to zero "
        << nReleased_ << " times" << nl;
}


// ************************************************************************* //
