/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "concentricLattice.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace particleLattices
{
    defineTypeNameAndDebug(concentric, 0);
    addToRunTimeSelectionTable(particleLattice, concentric, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleLattices::concentric::concentric
(
    const dictionary& dict,
    const wallSearch& search,
    const scalar dx
)
:
    particleLattice(search, dx),
    centre_(search.onMidPlane(dict.get<point>("centre")))
{
    if (search.nDims() != 2)
    {
        FatalIOErrorInFunction(dict)
            << "The lattice concentric is for 2D meshes only; this one has "
            << search.nDims() << " dimensions." << nl
            << "    Use the lattice cartesian"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleLattices::concentric::forPlaces(const receiver& take) const
{
    // In-plane axes
    const Vector<label>& geometricD = search_.mesh().geometricD();
    const direction a = geometricD[0] > 0 ? 0 : 1;
    const direction b = geometricD[2] > 0 ? 2 : 1;

    const boundBox& bounds = search_.bounds();
    const scalar farthest =
        mag(centre_ - bounds.midpoint()) + 0.5*bounds.mag();

    DynamicList<point> places;
    DynamicList<scalar> volumes;
    scalar turn = 0;

    for (label ring = 1; (ring - 0.5)*dx_ < farthest; ++ring)
    {
        const scalar radius = (ring - 0.5)*dx_;
        const scalar circumference = constant::mathematical::twoPi*radius;
        const label n = label(std::lround(circumference/dx_));

        for (label i = 0; i < n; ++i)
        {
            const scalar angle = constant::mathematical::twoPi*(i + turn)/n;

            point p(centre_);
            p[a] += radius*std::cos(angle);
            p[b] += radius*std::sin(angle);

            if (bounds.contains(p))
            {
                places.append(p);
                volumes.append(circumference*dx_/n);
            }
        }

        turn = 0.5 - turn;
    }

    take(pointField(places), scalarField(volumes));
}


// ************************************************************************* //
