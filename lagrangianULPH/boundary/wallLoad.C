/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallLoad.H"
#include "fvMesh.H"

#include <functional>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(wallLoad, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::label;

//- Hands the sums of every target to a function
template<class Block>
class eachTarget
:
    public ulph::sumSink<Block>
{
public:

    //- Sums, lane in them, record of the target
    typedef std::function<void(const Block&, int, label)> function;

    explicit eachTarget(const function& f)
    :
        f_(f)
    {}

    void take(const Block& sums) override
    {
        for (int l = 0; l < sums.count; ++l)
        {
            f_(sums, l, sums.first + l);
        }
    }

private:

    const function f_;
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallLoad::wallLoad
(
    const fvMesh& mesh,
    const ulphCloud& cloud,
    const ulphModels& models,
    const wallLayer& wall,
    const neighbourSearch& neighbours
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
    neighbours_(neighbours)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<Foam::wallLoad::load> Foam::wallLoad::evaluate
(
    const labelHashSet& patches
) const
{
    // Walls go on past cyclic patches and into what other processors have, as far as
    // fluid sees them
    const haloParticles& halo = neighbours_.halo();

    const label n = wall_.size();
    const label firstRecord = wall_.firstRecord;
    const ulph::clusterList& list = neighbours_.wallList();

    std::vector<load> loads;
    std::vector<label> place(n, -1);
    std::vector<unsigned char> asked(list.size(), 0);
    for (int i = 0; n && i < list.size(); ++i)
    {
        const label first = list[i].first - firstRecord;
        for (label j = first; j < first + list[i].count; ++j)
        {
            if (patches.found(wall_.patch(j)) && halo.holds(wall_.position(j)))
            {
                asked[i] = 1;
                place[j] = label(loads.size());
                loads.emplace_back();
                loads.back().where = wall_.nearestOnWall(j);
            }
        }
    }
    if (loads.empty())
    {
        return loads;
    }

    const int D = cloud_.D();
    const ulph::pairSums& sums = neighbours_.sums();
    const scalar K = wall_.inverseMoment();
    const scalar mu = models_.viscous->mu();
    const bool symmetric = models_.viscous->symmetric();
    eachTarget<ulph::forceBlock> reaction
    (
        [&](const ulph::forceBlock& block, const int l, const label record)
        {
            const label j = record - firstRecord;
            if (place[j] < 0)
            {
                return;
            }
            load& now = loads[place[j]];
            const scalar V = wall_.volume(j);
            const scalar pK = sums.pressure(record)*K;
            for (int k = 0; k < D; ++k)
            {
                const direction c = cloud_.axis(k);
                now.pressure[c] = -V*(block.pressure[k][l] + pK*block.b[k][l]);
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
    ulph::passRange range;
    range.mask = asked.data();
    ulph::viscousSettings viscous;
    viscous.eta2 = sqr(models_.viscous->eta()*cloud_.h());
    sums.force
    (
        list,
        range,
        mu > 0
      ? ulph::divergenceSums | ulph::viscousSums | ulph::symmetricViscousSums
      : unsigned(ulph::divergenceSums),
        viscous,
        reaction
    );
    return loads;
}


// ************************************************************************* //
