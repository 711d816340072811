/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionSelection.H"
#include "cellSet.H"
#include "inputChecks.H"
#include "pointSet.H"
#include "topoSetSource.H"
#include "volFields.H"
#include "HashSet.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

struct orLists
{
    boolList operator()(const boolList& a, const boolList& b) const
    {
        boolList either(a);

        forAll(b, i)
        {
            either[i] = a[i] || b[i];
        }

        return either;
    }
};


inline bool endsWith(const word& name, const std::string& ending)
{
    return
        name.size() > ending.size()
     && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}


//- Sources for points that go by sets and labels of the mesh, which mean
//- nothing for the points of a lattice
const wordHashSet notForLattice
({
    "cellToPoint",
    "faceToPoint",
    "labelToPoint",
    "pointToPoint",
    "setToPoint",
    "zoneToPoint"
});

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dictionary& Foam::regionSelection::sourceDict() const
{
    return dict_.found("sourceInfo") ? dict_.subDict("sourceInfo") : dict_;
}


Foam::wordList Foam::regionSelection::validSources()
{
    const wordList all(topoSetSource::wordConstructorTablePtr_->sortedToc());
    DynamicList<word> names;

    for (const word& name : all)
    {
        const bool byPoint =
            endsWith(name, "ToPoint") && !notForLattice.found(name);

        if (byPoint || endsWith(name, "ToCell"))
        {
            names.append(name);
        }
    }

    return wordList(names);
}


void Foam::regionSelection::selectCells(const word& source)
{
    cellSet cells(mesh_, "regionCells", mesh_.nCells()/10 + 1);

    autoPtr<topoSetSource> selector =
        topoSetSource::New(source, mesh_, sourceDict());
    selector->verbose(false);
    selector->applyToSet(topoSetSource::NEW, cells);

    inCell_.setSize(mesh_.nCells(), false);
    for (const label celli : cells.toc())
    {
        inCell_[celli] = true;
    }
}


void Foam::regionSelection::selectFromField(const word& fieldName)
{
    IOobject header
    (
        fieldName,
        mesh_.time().timeName(),
        mesh_,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    if (!header.typeHeaderOk<volScalarField>(true))
    {
        FatalIOErrorInFunction(entryPlace(dict_, "field"))
            << "There is no volScalarField " << header.objectPath() << nl
            << "    Make it (for instance with setFields), or choose the"
            << " region by a source"
            << exit(FatalIOError);
    }

    const volScalarField field(header, mesh_);

    inCell_.setSize(mesh_.nCells(), false);
    forAll(inCell_, celli)
    {
        inCell_[celli] = field[celli] > 0.5;
    }
}


Foam::boolList Foam::regionSelection::byPointSource
(
    const pointField& points
) const
{
    // The sources look at mesh points: give them a mesh that has no others
    pointField copy(points);
    polyMesh latticeMesh
    (
        IOobject
        (
            "latticePoints",
            mesh_.time().constant(),
            mesh_.time(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        std::move(copy),
        faceList(),
        labelList(),
        labelList(),
        false
    );

    pointSet chosen(latticeMesh, "regionPoints", points.size()/10 + 1);

    autoPtr<topoSetSource> selector =
        topoSetSource::New(pointSource_, latticeMesh, sourceDict());
    selector->verbose(false);
    selector->applyToSet(topoSetSource::NEW, chosen);

    boolList held(points.size(), false);
    for (const label pointi : chosen.toc())
    {
        held[pointi] = true;
    }

    return held;
}


Foam::boolList Foam::regionSelection::byCells(const pointField& points) const
{
    const labelList cells(locator_->find(points));
    boolList held(points.size(), false);

    forAll(cells, i)
    {
        held[i] = cells[i] >= 0 && inCell_[cells[i]];
    }

    if (Pstream::parRun())
    {
        reduce(held, orLists());
    }

    return held;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::regionSelection::regionSelection
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    dict_(dict)
{
    if (!dict.found("source") && !dict.found("field"))
    {
        FatalIOErrorInFunction(dict)
            << "Region " << dict.dictName() << " needs either the entry"
            << " source (a topoSetSource such as boxToPoint) or the entry"
            << " field (a volScalarField such as alpha.water)"
            << exit(FatalIOError);
    }

    // Beside a source it is an entry of that source
    if (!dict.found("source"))
    {
        selectFromField(dict.get<word>("field"));
        locator_.reset(new cellLocator(mesh));
        return;
    }

    const word source(dict.get<word>("source"));
    const wordList valid(validSources());

    if (!valid.found(source))
    {
        FatalIOErrorInFunction(entryPlace(dict, "source"))
            << "Unknown source " << source << " of region " << dict.dictName()
            << nl << nl
            << "Valid sources (those for points are exact, those for cells"
            << " follow the mesh) are" << nl
            << valid << nl
            << exit(FatalIOError);
    }

    if (endsWith(source, "ToPoint"))
    {
        pointSource_ = source;
    }
    else
    {
        selectCells(source);
        locator_.reset(new cellLocator(mesh));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boolList Foam::regionSelection::holds(const pointField& points) const
{
    return pointSource_.empty() ? byCells(points) : byPointSource(points);
}


// ************************************************************************* //
