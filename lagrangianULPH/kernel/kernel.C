/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "kernel.H"

#include "inputChecks.H"
#include "wordList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static word knownKernel(const dictionary& dict)
{
    const word name(dict.getOrDefault<word>("kernel", "WendlandC2"));

    wordList valid;
    for (const std::string& known : ulph::pairSums::kernels())
    {
        valid.append(known);
    }
    if (!valid.found(name))
    {
        FatalIOErrorInFunction(entryPlace(dict, "kernel"))
            << "Unknown kernel type " << name << nl << nl
            << "Valid kernel types are" << nl << valid << nl
            << exit(FatalIOError);
    }
    return name;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::kernel::kernel(const dictionary& dict, const int D, const scalar dx)
:
    name_(knownKernel(dict)),
    D_(D),
    dx_(dx),
    h_(dx*getInRange(dict, "hByDx", 2, scalarMinMax(1, 4)))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::unique_ptr<ulph::pairSums> Foam::kernel::sums(const bool mixed) const
{
    return ulph::pairSums::New(name_, mixed, D_, 2*h_);
}


Foam::scalar Foam::kernel::latticeMoment() const
{
    const std::unique_ptr<ulph::pairSums> weights(sums(false));
    const int reach = int(2*h_/dx_);
    const int reachK = D_ == 3 ? reach : 0;

    scalar sum = 0;
    for (int k = -reachK; k <= reachK; ++k)
    {
        for (int j = -reach; j <= reach; ++j)
        {
            for (int i = -reach; i <= reach; ++i)
            {
                const scalar r = dx_*std::sqrt(scalar(i*i + j*j + k*k));
                sum += weights->weight(r)*sqr(i*dx_);
            }
        }
    }
    return sum*std::pow(dx_, D_);
}


// ************************************************************************* //
