/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallLoad.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(wallLoad, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::label;

//- Sums of a pass by wall particle, first record first
template<class Block>
class wallSums
:
    public ulph::sumSink<Block>
{
    const label firstRecord_;

    //- Where target l of a block is stored
    const std::function<void(const Block&, int l, label wall)> store_;

public:

    template<class Store>
    wallSums(const label firstRecord, const Store& store)
    :
        firstRecord_(firstRecord),
        store_(store)
    {}

    void take(const Block& sums) override
    {
        for (int l = 0; l < sums.count; ++l)
        {
            store_(sums, l, sums.first - firstRecord_ + l);
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallLoad::wallLoad
(
    const fvMesh& mesh,
    const ulphCloud& cloud,
    const ulphModels& models,
    const wallLayer& wall,
    const neighbourSearch& neighbours,
    const wallSearch& search
)
:
    regIOobject
    (
        IOobject
        (
            typeName, mesh.time().timeName(), mesh,
            IOobject::NO_READ, IOobject::NO_WRITE
        )
    ),
    cloud_(cloud),
    models_(models),
    wall_(wall),
    neighbours_(neighbours),
    search_(search)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<Foam::wallLoad::load> Foam::wallLoad::evaluate() const
{
    const label n = wall_.size();
    if (n == 0 || neighbours_.nBuilds() == 0)
    {
        return {};
    }

    const int D = cloud_.D();
    const ulph::pairSums& sums = neighbours_.sums();
    const ulph::clusterList& list = neighbours_.wallList();
    std::vector<load> loads(n);

    // By the sum over neighbours of V_I x first, which only p_J needs
    wallSums<ulph::geometryBlock> gradient
    (
        wall_.firstRecord,
        [&](const ulph::geometryBlock& block, const int l, const label j)
        {
            const scalar p = sums.pressure(wall_.firstRecord + j);
            for (int k = 0; k < D; ++k)
            {
                loads[j].pressure[cloud_.axis(k)] = p*block.b[k][l];
            }
        }
    );
    const scalar mu = models_.viscous->mu();
    const bool symmetric = models_.viscous->symmetric();
    const scalar K = 1/cloud_.shared().beta;
    wallSums<ulph::forceBlock> reaction
    (
        wall_.firstRecord,
        [&](const ulph::forceBlock& block, const int l, const label j)
        {
            load& now = loads[j];
            const scalar V = wall_.volume(j);
            for (int k = 0; k < D; ++k)
            {
                const direction c = cloud_.axis(k);
                now.pressure[c] =
                    -V*(block.pressure[k][l] + K*now.pressure[c]);
                if (mu > 0)
                {
                    now.viscous[c] =
                        symmetric
                      ? 0.5*mu*V*(block.symmetricA[k][l] + K*block.A[k][l])
                      : mu*V*block.symmetricA[k][l];
                }
            }
        }
    );
    for (load& now : loads)
    {
        now.pressure = now.viscous = Zero;
    }

    ulph::viscousSettings viscous;
    viscous.eta2 = sqr(models_.viscous->eta()*cloud_.h());
    sums.geometry(list, {}, ulph::momentSums, gradient);
    sums.force
    (
        list,
        mu > 0
      ? unsigned(ulph::viscousSums | ulph::symmetricViscousSums)
      : unsigned(ulph::pressureSums),
        viscous,
        reaction
    );

    #pragma omp parallel for schedule(dynamic, 64)
    for (label j = 0; j < n; ++j)
    {
        const wallSearch::wallPoint nearest(search_.nearest(wall_.position(j)));
        loads[j].patch = nearest.patch;
        loads[j].where = nearest.position;
    }
    return loads;
}


// ************************************************************************* //
