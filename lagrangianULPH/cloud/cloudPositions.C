/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudPositions.H"
#include "Time.H"

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

template<class Geometry, std::size_t nLabels>
static void readEntry(Istream& is, Geometry& geometry, label (&labels)[nLabels])
{
    if (is.format() == IOstream::ASCII)
    {
        is  >> geometry;
        for (label& l : labels)
        {
            is  >> l;
        }
    }
    else
    {
        char buffer[entryBytes<Geometry, nLabels>];
        is.read(buffer, sizeof(buffer));
        std::memcpy(geometry.begin(), buffer, sizeof(Geometry));
        std::memcpy(labels, buffer + sizeof(Geometry), sizeof(labels));
    }
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
    locator_(locator),
    positions_(positions),
    cells_(cells)
{}


Foam::cloudPositions::cloudPositions
(
    const cloud& registry,
    const word& instance,
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
            instance,
            registry,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    ),
    geometry_(geometry),
    locator_(locator),
    positions_(positions),
    cells_(cells)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::cloudPositions::found
(
    const Time& time,
    const word& instance,
    const cloud::geometryType geometry
)
{
    const fileName path
    (
        time.path()/instance/cloud::prefix/ulphCloud::cloudName
       /cloud::geometryTypeNames[geometry]
    );
    return isFile(path) || isFile(path + ".gz");
}


bool Foam::cloudPositions::found(const Time& time, const word& instance)
{
    return
        found(time, instance, cloud::geometryType::POSITIONS)
     || found(time, instance, cloud::geometryType::COORDINATES);
}



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
        barycentric coordinates;
        label cell[1] = {};
        label place[3] = {};
        geometry_ == cloud::geometryType::POSITIONS
      ? readEntry(is, positions_[i], cell)
      : readEntry(is, coordinates, place);

        if (!is.good())
        {
            FatalIOErrorInFunction(is)
                << "The file ends within particle " << i << " of " << n << nl
                << "    Restart from another time directory."
                << exit(FatalIOError);
        }
        cells_[i] = cell[0];
        if (geometry_ == cloud::geometryType::COORDINATES)
        {
            cells_[i] = place[0];
            if (cells_[i] < 0 || cells_[i] >= locator_.mesh().nCells())
            {
                FatalIOErrorInFunction(is)
                    << "Particle " << i << " is in cell " << cells_[i]
                    << ", which the mesh has not" << exit(FatalIOError);
            }
            positions_[i] =
                locator_.position(cells_[i], {place[1], place[2], coordinates});
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
                locator_.place(positions_[i], cells_[i])
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
