/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphCloud.H"
#include "fvMesh.H"

#include <numeric>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(ulphCloud, 0);
}

const Foam::word Foam::ulphCloud::cloudName("fluid");


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static particleField* fieldOf
(
    const HashPtrTable<particleField>& fields,
    const word& name
)
{
    const auto iter = fields.cfind(name);
    return iter.found() ? *iter : nullptr;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::ulphCloud::ulphCloud
(
    const fvMesh& mesh,
    const properties& shared,
    const wordRes& written
)
:
    cloud(mesh, cloudName),
    mesh_(mesh),
    properties_(shared),
    offPlane_(Zero),
    written_(written)
{
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        if (mesh.geometricD()[cmpt] > 0)
        {
            axes_.push_back(cmpt);
        }
        else
        {
            offPlane_[cmpt] = mesh.bounds().centre()[cmpt];
        }
    }

    x_ = &requireState("x", D());
    v_ = &requireState("v", D());
    densityExcess_ = &requireState("densityExcess", 1);
    mass_ = &requireState("mass", 1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::ulphCloud::position(const label i) const
{
    point p(offPlane_);
    for (int k = 0; k < D(); ++k)
    {
        p[axes_[k]] = x()(i, k);
    }
    return p;
}


Foam::pointField Foam::ulphCloud::positions() const
{
    pointField all(size_);
    forAll(all, i)
    {
        all[i] = position(i);
    }
    return all;
}


Foam::vector Foam::ulphCloud::toVector
(
    const particleField& field,
    const label i
) const
{
    vector value(Zero);
    for (int k = 0; k < D(); ++k)
    {
        value[axes_[k]] = field(i, k);
    }
    return value;
}


ulph::particleView Foam::ulphCloud::view() const
{
    ulph::particleView particles(totalView());
    particles.n = size_;
    return particles;
}


ulph::particleView Foam::ulphCloud::haloView() const
{
    ulph::particleView images(totalView());
    images.n = nHalo_;
    for (int k = 0; k < D(); ++k)
    {
        images.x[k] += size_;
    }
    return images;
}


ulph::particleView Foam::ulphCloud::totalView() const
{
    ulph::particleView all;
    all.D = D();
    all.n = total();
    for (int k = 0; k < D(); ++k)
    {
        all.x[k] = x().component(k);
    }
    return all;
}


void Foam::ulphCloud::volumes
(
    const label first,
    const label count,
    ulph::laneRow& V
) const
{
    const double* const m = mass().component(0) + first;
    const double* const rho1 = densityExcess().component(0) + first;
    ulph::forLanes(count, [&](const int l)
    {
        V[l] = m[l]/(rho0() + rho1[l]);
    });
}


Foam::particleField& Foam::ulphCloud::require
(
    const word& name,
    const int nComponents
)
{
    if (!derived_.found(name))
    {
        derived_.set
        (
            name,
            new particleField(nComponents, properties_.mixed)
        );
        derived_[name]->reset(total());
    }
    return *derived_[name];
}


Foam::particleField& Foam::ulphCloud::requireState
(
    const word& name,
    const int nComponents,
    const bool single
)
{
    if (!state_.found(name))
    {
        state_.set(name, new particleField(nComponents, single));
        state_[name]->reset(total());
    }
    return *state_[name];
}


Foam::particleField& Foam::ulphCloud::requireSaved
(
    const word& name,
    const bool isZero
)
{
    if (!state_.found(name))
    {
        state_.set(name, new particleField(1, properties_.mixed));
        state_[name]->reset(total());
        saved_.append(name);
        savedZero_ = savedZero_ && isZero;
    }
    return *state_[name];
}


const Foam::particleField* Foam::ulphCloud::saved(const word& name) const
{
    return fieldOf(state_, name);
}


Foam::particleField* Foam::ulphCloud::saved(const word& name)
{
    return fieldOf(state_, name);
}


const Foam::particleField* Foam::ulphCloud::derived(const word& name) const
{
    return fieldOf(derived_, name);
}


Foam::particleField* Foam::ulphCloud::derived(const word& name)
{
    return fieldOf(derived_, name);
}


Foam::label Foam::ulphCloud::bytes() const
{
    label sum = sizeof(label);
    for (const word& name : state_.toc())
    {
        sum += state_[name]->bytes();
    }
    for (const word& name : derived_.toc())
    {
        sum += derived_[name]->bytes();
    }
    return sum;
}


void Foam::ulphCloud::set
(
    const UList<point>& positions,
    const UList<vector>& velocities,
    const UList<scalar>& densityExcesses,
    const UList<scalar>& masses
)
{
    size_ = positions.size();
    nHalo_ = 0;
    for (const word& name : state_.toc())
    {
        state_[name]->reset(size_);
    }
    for (label i = 0; i < size_; ++i)
    {
        for (int k = 0; k < D(); ++k)
        {
            x().set(i, k, positions[i][axes_[k]]);
            v().set(i, k, velocities[i][axes_[k]]);
        }
        densityExcess().set(i, 0, densityExcesses[i]);
        mass().set(i, 0, masses[i]);
    }
    origId_.resize(size_);
    std::iota(origId_.begin(), origId_.end(), 0);
    sizeDerived();
    savedKnown_ = savedZero_;
}


void Foam::ulphCloud::sizeDerived()
{
    for (const word& name : derived_.toc())
    {
        if (derived_[name]->size() != total())
        {
            derived_[name]->reset(total());
        }
    }
}


void Foam::ulphCloud::permute(const ulph::particleOrder& order)
{
    for (const word& name : state_.toc())
    {
        state_[name]->permute(order);
    }
    ulph::permute(origId_.data(), order);
}


void Foam::ulphCloud::translate(const label i, const vector& by)
{
    for (const char* const name : {"x", "xKept"})
    {
        const auto iter = state_.find(name);
        if (iter.found())
        {
            for (int k = 0; k < D(); ++k)
            {
                (*iter)->component(k)[i] += by[axes_[k]];
            }
        }
    }
}


void Foam::ulphCloud::setHalo(const label n)
{
    nHalo_ = n;
    for (const word& name : state_.toc())
    {
        state_[name]->resize(total());
    }
    sizeDerived();
}


// ************************************************************************* //
