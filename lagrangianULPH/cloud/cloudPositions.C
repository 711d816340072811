/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudPositions.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameWithName(cloudPositions, "Cloud<ulphParticle>");
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Bytes of a binary entry, without padding
template<class Geometry, int nLabels>
constexpr std::streamsize entryBytes = sizeof(Geometry) + nLabels*sizeof(label);

template<class Geometry, std::size_t nLabels>
static void writeEntry
(
    Ostream& os,
    const Geometry& geometry,
    const label (&labels)[nLabels]
)
{
    if (os.format() == IOstream::ASCII)
    {
        os  << geometry;
        for (const label l : labels)
        {
            os  << token::SPACE << l;
        }
    }
    else
    {
        char buffer[entryBytes<Geometry, nLabels>];
        std::memcpy(buffer, &geometry, sizeof(Geometry));
        std::memcpy(buffer + sizeof(Geometry), labels, sizeof(labels));
        os.write(buffer, sizeof(buffer));
    }
    os  << nl;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cloudPositions::cloudPositions
(
    const cloud& registry,
    const cloud::geometryType geometry,
    const cellLocator& locator,
    pointField& positions,
    labelList& cells
)
:
    regIOobject
    (
        IOobject
        (
            cloud::geometryTypeNames[geometry],
            registry.time().timeName(),
            registry,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        )
    ),
    geometry_(geometry),
    locator_(&locator),
    positions_(positions),
    cells_(cells)
{}


Foam::cloudPositions::cloudPositions
(
    const cloud& registry,
    const word& instance,
    pointField& positions,
    labelList& cells
)
:
    regIOobject
    (
        IOobject
        (
            cloud::geometryTypeNames[cloud::geometryType::POSITIONS],
            instance,
            registry,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    ),
    geometry_(cloud::geometryType::POSITIONS),
    locator_(nullptr),
    positions_(positions),
    cells_(cells)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cloudPositions::readAll()
{
    // The header names the writer's own particle class: any will do
    Istream& is = readStream(word::null);

    const label n(readLabel(is));
    if (n < 0)
    {
        FatalIOErrorInFunction(is)
            << "A number of particles was expected, found " << n
            << exit(FatalIOError);
    }
    positions_.resize(n);
    cells_.resize(n);

    is.readBeginList("positions");
    for (label i = 0; i < n; ++i)
    {
        if (is.format() == IOstream::ASCII)
        {
            is  >> positions_[i] >> cells_[i];
        }
        else
        {
            char buffer[entryBytes<point, 1>];
            is.read(buffer, sizeof(buffer));
            std::memcpy(positions_[i].begin(), buffer, sizeof(point));
            std::memcpy(&cells_[i], buffer + sizeof(point), sizeof(label));
        }
        if (!is.good())
        {
            FatalIOErrorInFunction(is)
                << "The file ends within particle " << i << " of " << n << nl
                << "    Restart from another time directory."
                << exit(FatalIOError);
        }
    }
    is.readEndList("positions");
    close();
}


bool Foam::cloudPositions::writeData(Ostream& os) const
{
    os  << positions_.size() << nl << token::BEGIN_LIST << nl;
    forAll(positions_, i)
    {
        if (geometry_ == cloud::geometryType::POSITIONS)
        {
            writeEntry(os, positions_[i], {cells_[i]});
        }
        else
        {
            const cellLocator::tetPlace place
            (
                locator_->place(positions_[i], cells_[i])
            );
            writeEntry
            (
                os, place.coordinates, {cells_[i], place.tetFace, place.tetPt}
            );
        }
    }
    os  << token::END_LIST << endl;

    return os.good();
}


// ************************************************************************* //
