/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shifting.H"
#include "freeSurface.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::shifting::shifting
(
    const scalar C,
    const ulphCloud& cloud,
    const word& field,
    const scalar scale
)
:
    D_(cloud.D()),
    field_(field),
    scale_(scale),
    C_(C),
    cap_(0.2*cloud.dx()),
    thin_(freeSurface::thinFraction*cloud.shared().beta/sqr(cloud.dx()))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::shifting::displacement
(
    const scalar VmaxDt,
    const label first,
    const label count,
    ulph::laneRow* dx
) const
{
    direction_->load(first, count, dx);

    ulph::laneRow surface;
    ulph::laneRow lambda;
    ulph::laneRow n[3];
    if (surface_)
    {
        surface_->load(0, first, count, surface);
        lambda_->load(0, first, count, lambda);
        normal_->load(first, count, n);
    }

    label nCapped = 0;
    for (label l = 0; l < count; ++l)
    {
        scalar factor = -C_*scale_*VmaxDt;
        if (surface_ && surface[l] != freeSurface::interior)
        {
            scalar normalPart = 0;
            for (int k = 0; k < D_; ++k)
            {
                normalPart += dx[k][l]*n[k][l];
            }
            for (int k = 0; k < D_; ++k)
            {
                dx[k][l] -= normalPart*n[k][l];
            }
            factor *= lambda[l] >= thin_;
        }

        scalar length2 = 0;
        for (int k = 0; k < D_; ++k)
        {
            dx[k][l] *= factor;
            length2 += sqr(dx[k][l]);
        }
        if (length2 > sqr(cap_))
        {
            ++nCapped;
            for (int k = 0; k < D_; ++k)
            {
                dx[k][l] *= cap_/std::sqrt(length2);
            }
        }
    }
    if (nCapped)
    {
        #pragma omp atomic
        nCapped_ += nCapped;
    }
}


Foam::effectNeeds Foam::shifting::needs() const
{
    effectNeeds all;
    all.fields.set(field_, D_);
    all.geometry = ulph::momentSums;
    return all;
}


void Foam::shifting::bind(ulphCloud& cloud)
{
    direction_ = cloud.derived(field_);
    surface_ = cloud.derived("surface");
    normal_ = cloud.derived("normal");
    lambda_ = cloud.derived("lambda");
}


void Foam::shifting::report(Ostream& os) const
{
    os  << "    shifting: cut to 0.2 dx "
        << returnReduce(nCapped_, sumOp<label>()) << " times" << nl;
}


// ************************************************************************* //
