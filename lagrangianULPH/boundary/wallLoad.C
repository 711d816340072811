/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallLoad.H"

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

std::vector<Foam::wallLoad::load> Foam::wallLoad::evaluate() const
{
    const label n = wall_.size();
    if (n == 0)
    {
        return {};
    }

    const int D = cloud_.D();
    const label firstRecord = wall_.firstRecord;
    const ulph::pairSums& sums = neighbours_.sums();
    const ulph::clusterList& list = neighbours_.wallList();
    const scalar K = wall_.inverseMoment();
    std::vector<load> loads(n);

    eachTarget<ulph::geometryBlock> own
    (
        [&](const ulph::geometryBlock& block, const int l, const label record)
        {
            const label j = record - firstRecord;
            const scalar factor = wall_.volume(j)*sums.pressure(record)*K;
            for (int k = 0; k < D; ++k)
            {
                loads[j].pressure[cloud_.axis(k)] -= factor*block.b[k][l];
            }
        }
    );
    sums.geometry(list, {}, ulph::momentSums, own);

    const scalar mu = models_.viscous->mu();
    const bool symmetric = models_.viscous->symmetric();
    eachTarget<ulph::forceBlock> fluids
    (
        [&](const ulph::forceBlock& block, const int l, const label record)
        {
            load& now = loads[record - firstRecord];
            const scalar V = wall_.volume(record - firstRecord);
            for (int k = 0; k < D; ++k)
            {
                const direction c = cloud_.axis(k);
                now.pressure[c] -= V*block.pressure[k][l];
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
    ulph::viscousSettings viscous;
    viscous.eta2 = sqr(models_.viscous->eta()*cloud_.h());
    sums.force
    (
        list,
        mu > 0
      ? unsigned(ulph::viscousSums | ulph::symmetricViscousSums)
      : unsigned(ulph::pressureSums),
        viscous,
        fluids
    );

    #pragma omp parallel for schedule(static)
    for (label j = 0; j < n; ++j)
    {
        loads[j].patch = wall_.patch(j);
        loads[j].where = wall_.nearestOnWall(j);
    }
    return loads;
}


// ************************************************************************* //
