/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "schedule.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What every scene needs: continuity and momentum
static effectNeeds coreNeeds(const ulphCloud& cloud)
{
    effectNeeds core;
    core.fields.set("kernelGradient", cloud.D());
    core.fields.set("divergence", 1);
    core.fields.set("acceleration", cloud.D());
    core.geometry = ulph::momentSums | ulph::velocityGradientSums;
    core.force = ulph::pressureSums;
    return core;
}


static wordList sumNames(const effectNeeds& needs)
{
    wordList names;
    const auto add = [&](const bool taken, const char* const name)
    {
        if (taken)
        {
            names.append(name);
        }
    };
    add(needs.geometry & ulph::momentSums, "moment");
    add(needs.geometry & ulph::velocityGradientSums, "velocityGradient");
    add(needs.geometry & ulph::gradientSums, "densityGradient");
    add(needs.geometry & ulph::laplacianSums, "densityLaplacian");
    add(needs.geometry & ulph::spacingSums, "spacing");
    add(needs.force & ulph::densityDiffusionSums, "neighbourGradient");
    add(needs.force & ulph::viscousSums, "viscous");
    add(needs.force & ulph::symmetricViscousSums, "symmetricViscous");
    return names;
}


static label fieldBytes(const effectNeeds& needs, const bool mixed)
{
    label components = 0;
    for (const word& name : needs.fields.toc())
    {
        components += needs.fields[name];
    }
    return components*(mixed ? sizeof(float) : sizeof(double));
}


static void printRow
(
    const word& family,
    const word& model,
    const effectNeeds& needs,
    const bool mixed,
    Ostream& os
)
{
    char line[96];
    std::snprintf
    (
        line, sizeof(line), "    %-18s %-20s %-4s %6d   ",
        family.c_str(),
        model.c_str(),
        model == "none" ? "off" : "on",
        int(fieldBytes(needs, mixed))
    );
    os  << line;
    for (const word& name : sumNames(needs))
    {
        os  << name << ' ';
    }
    os  << nl;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::schedule::schedule(ulphModels& models, ulphCloud& cloud)
:
    needs_(coreNeeds(cloud))
{
    UPtrList<effect> effects(models.all());
    for (const effect& e : effects)
    {
        needs_.add(e.needs());
    }
    for (const word& name : needs_.fields.sortedToc())
    {
        cloud.require(name, needs_.fields[name]);
    }
    for (const word& name : needs_.state.sortedToc())
    {
        cloud.requireSaved(name, needs_.state[name]);
    }
    for (effect& e : effects)
    {
        e.bind(cloud);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::schedule::print
(
    ulphModels& models,
    const ulphCloud& cloud,
    Ostream& os
)
{
    const bool mixed = cloud.shared().mixed;

    os  << nl << "Schedule" << nl
        << "    effect             model                on/off bytes   "
        << "pair sums" << nl;

    printRow("continuity", "always", coreNeeds(cloud), mixed, os);
    UPtrList<effect> effects(models.all());
    for (const effect& e : effects)
    {
        printRow(e.family(), e.model(), e.needs(), mixed, os);
    }
    os  << "    state and derived fields: " << cloud.bytes()
        << " bytes per particle" << nl << endl;
}


// ************************************************************************* //
