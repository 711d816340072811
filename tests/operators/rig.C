/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rig.H"

#include "IStringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static ulphCloud::properties shared
(
    const dictionary& dict,
    const kernel& weight
)
{
    ulphCloud::properties p;
    p.dx = dict.get<scalar>("dx");
    p.h = weight.h();
    p.rho0 = dict.get<scalar>("rho0");
    p.c0 = dict.get<scalar>("c0");
    p.beta = weight.latticeMoment();
    p.mixed = dict.get<word>("precision") == "mixed";
    return p;
}


static dictionary parse(const std::string& content)
{
    IStringStream stream(content);
    return dictionary(stream);
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::testCase::testCase(const fileName& name)
:
    time(Time::controlDictName, cwd(), name),
    mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            time.timeName(),
            time,
            IOobject::MUST_READ
        )
    )
{}


Foam::rig::rig
(
    const testCase& where,
    const std::string& properties,
    const fluidState& state
)
:
    dict_(parse(properties)),
    weight_(dict_, where.mesh.nGeometricD(), dict_.get<scalar>("dx")),
    search_(where.mesh),
    motion_(dict_, where.mesh),
    bodies_(dict_, search_, dict_.get<scalar>("dx")),
    cloud(where.mesh, shared(dict_, weight_), wordRes()),
    models(dict_, cloud),
    wall
    (
        cloud, bodies_, *models.boundary, *models.force, motion_, *models.state
    ),
    neighbours(cloud, wall, weight_, dict_.getOrDefault<scalar>("skin", 0.2)),
    contact(cloud, bodies_),
    plan(models, cloud),
    rates(cloud, models, plan, wall, neighbours, contact, times)
{
    pointField x(state.size());
    vectorField v(state.size(), Zero);
    scalarField rho1(state.size());
    scalarField m(state.size());
    forAll(x, i)
    {
        x[i] = unsolved(state.x[i]);
        for (int k = 0; k < cloud.D(); ++k)
        {
            v[i][cloud.axis(k)] = state.v[i][k];
        }
        rho1[i] = state.rho1[i];
        m[i] = state.m[i];
    }
    cloud.set(x, v, rho1, m);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fluidState Foam::fluidState::random
(
    const int D,
    const double dx,
    const std::vector<vec>& places
)
{
    fluidState state;
    randomVectors random(D, 11);
    state.x = places;
    for (int i = 0; i < state.size(); ++i)
    {
        state.v.push_back(random.vector(1));
        state.rho1.push_back(random.number(-1, 1) + (places[i][0] > 0.2));
        state.m.push_back(1000*std::pow(dx, D)*random.number(0.9, 1.1));
    }
    return state;
}


Foam::fluidState Foam::fluidState::ball(const int D, const double dx)
{
    const double radius = (D == 2 ? 10 : 6.5)*dx;
    vec corner(vec::Zero());
    corner.head(D).setConstant(std::ceil(radius/dx)*dx);

    std::vector<vec> places;
    for (const vec& x : jitteredLattice(D, dx, -corner, corner, 0.25))
    {
        if (x.norm() < radius)
        {
            places.push_back(x);
        }
    }
    return random(D, dx, places);
}


Foam::fluidState Foam::fluidState::rotated(const mat& R) const
{
    fluidState turned(*this);
    for (int i = 0; i < size(); ++i)
    {
        turned.x[i] = R*x[i];
        turned.v[i] = R*v[i];
    }
    return turned;
}


void Foam::rig::evaluate()
{
    rates.updateNeighbours(0);
    rates.geometry(0);
    rates.findSurface();
    rates.force(0, 0, false);
}


double Foam::rig::scalarOf(const word& field, const int i) const
{
    return (*cloud.derived(field))(i);
}


Foam::vec Foam::rig::vectorOf(const word& field, const int i) const
{
    vec a(vec::Zero());
    for (int k = 0; k < cloud.D(); ++k)
    {
        a[k] = (*cloud.derived(field))(i, k);
    }
    return a;
}


double Foam::rig::diffusionOf(const int i) const
{
    const particleField* const part = cloud.saved("neighbourDiffusion");
    return scalarOf("densityDiffusion", i) + (part ? (*part)(i) : 0);
}


Foam::vec Foam::rig::shiftOf(const int i) const
{
    return models.shift->scale()*vectorOf(models.shift->field(), i);
}


Foam::mat Foam::rig::tensorOf(const word& field, const int i) const
{
    const int D = cloud.D();
    mat A(mat::Zero());
    for (int k = 0; k < D; ++k)
    {
        for (int l = 0; l < D; ++l)
        {
            A(k, l) =
                (*cloud.derived(field))(i, ulph::symmetricIndex(D, k, l));
        }
    }
    return A;
}


std::vector<int> Foam::rig::places() const
{
    std::vector<int> at(size());
    for (int i = 0; i < size(); ++i)
    {
        at[cloud.origId()[i]] = i;
    }
    return at;
}


Foam::vec Foam::rig::solved(const Foam::vector& a) const
{
    vec b(vec::Zero());
    for (int k = 0; k < cloud.D(); ++k)
    {
        b[k] = a[cloud.axis(k)];
    }
    return b;
}


Foam::point Foam::rig::unsolved(const vec& x) const
{
    point p(cloud.mesh().bounds().centre());
    for (int k = 0; k < cloud.D(); ++k)
    {
        p[cloud.axis(k)] = x[k];
    }
    return p;
}


// ************************************************************************* //
