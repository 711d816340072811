/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ulphFront.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(ulphFront, 0);
    addToRunTimeSelectionTable(functionObject, ulphFront, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::List<Foam::string> Foam::functionObjects::ulphFront::remarks() const
{
    OStringStream os;
    os  << "Front [m], [m/s] along " << direction_ << " from " << origin_;
    return {os.str()};
}


Foam::scalarList Foam::functionObjects::ulphFront::row()
{
    const ulphCloud& cloud = particles();
    const particleField* const surface = cloud.derived("surface");

    // Place and velocity of the foremost
    typedef Tuple2<scalar, scalar> placed;
    placed front(-GREAT, 0);
    scalar drops = -GREAT;
    for (label i = 0; i < cloud.size(); ++i)
    {
        const scalar x = (cloud.position(i) - origin_) & direction_;
        drops = max(drops, x);
        const bool drop = surface && (*surface)(i) == freeSurface::splash;
        if (x > front.first() && !drop)
        {
            front = placed(x, cloud.toVector(cloud.v(), i) & direction_);
        }
    }
    reduce(drops, maxOp<scalar>());
    combineReduce(front, [](placed& a, const placed& b)
    {
        if (b.first() > a.first()) a = b;
    });

    // Where all are drops there is no other front than theirs
    const scalar half = 0.5*cloud.dx();
    return
    {
        (front.first() > -GREAT ? front.first() : drops) + half,
        front.second(),
        drops + half
    };
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::ulphFront::ulphFront
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    ulphFunctionObject(name, runTime, dict, typeName)
{
    read(dict);
    start();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::ulphFront::read(const dictionary& dict)
{
    direction_ =
        unitDirection(dict, "direction", dict.get<vector>("direction"));
    origin_ = dict.getOrDefault<point>("origin", Zero);

    return ulphFunctionObject::read(dict);
}


// ************************************************************************* //
