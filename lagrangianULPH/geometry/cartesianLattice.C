/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cartesianLattice.H"
#include "coordinateRotation.H"
#include "labelVector.H"
#include "addToRunTimeSelectionTable.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace particleLattices
{
    defineTypeNameAndDebug(cartesian, 0);
    addToRunTimeSelectionTable(particleLattice, cartesian, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleLattices::cartesian::cartesian
(
    const dictionary& dict,
    const wallSearch& search,
    const scalar dx
)
:
    particleLattice(search, dx),
    axes_(tensor::I)
{
    if (dict.found("rotation"))
    {
        axes_ = coordinateRotation::New(dict.subDict("rotation"))->R();
    }

    for (direction d = 0; d < 3; ++d)
    {
        vector empty(Zero);
        empty[d] = search.mesh().geometricD()[d] < 0;

        if (magSqr((axes_ & empty) - empty) > SMALL)
        {
            FatalIOErrorInFunction(dict)
                << "The rotation of the lattice turns the empty direction "
                << empty << " of this 2D mesh." << nl
                << "    Turn the lattice about that direction only"
                << exit(FatalIOError);
        }
    }

    for (const point& p : search.boundary().tree().points())
    {
        bounds_.add(axes_.T() & p);
    }

    origin_ = bounds_.min();

    if (dict.found("origin"))
    {
        origin_ = axes_.T() & dict.get<point>("origin");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleLattices::cartesian::forPlaces(const receiver& take) const
{
    // A little slack: the last place may be round-off outside the bounds
    const vector slack(vector::uniform(1e-6*dx_));
    labelVector first, n;

    for (direction d = 0; d < 3; ++d)
    {
        const vector low((bounds_.min() - slack - origin_)/dx_);
        const vector high((bounds_.max() + slack - origin_)/dx_);

        first[d] = label(std::ceil(low[d] - 0.5));
        n[d] = label(std::floor(high[d] - 0.5)) - first[d] + 1;

        if (search_.mesh().geometricD()[d] < 0)
        {
            first[d] = 0;
            n[d] = 1;
        }
    }

    const scalar volume = std::pow(dx_, search_.nDims());
    DynamicList<point> places;

    const auto hand = [&]()
    {
        take(pointField(places), scalarField(places.size(), volume));
        places.clear();
    };

    for (label k = 0; k < n.z(); ++k)
    {
        for (label j = 0; j < n.y(); ++j)
        {
            for (label i = 0; i < n.x(); ++i)
            {
                const vector steps
                (
                    first.x() + i + 0.5,
                    first.y() + j + 0.5,
                    first.z() + k + 0.5
                );

                places.append
                (
                    search_.onMidPlane(axes_ & (origin_ + dx_*steps))
                );
            }

            if (places.size() > chunkSize) hand();
        }
    }

    hand();
}


// ************************************************************************* //
