/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::array<Foam::stepTools::savedField, 3> Foam::stepTools::savedFields
(
    const word& copy
)
{
    ulphCloud& cloud = rates_.cloud();
    return
    {{
        {cloud.x(), cloud.requireState("x" + copy, cloud.D())},
        {cloud.v(), cloud.requireState("v" + copy, cloud.D())},
        {cloud.densityExcess(), cloud.requireState("densityExcess" + copy, 1)}
    }};
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stepTools::keep(const scalar dt)
{
    kept_ = guard_.strained(maxSpeed_, maxExcess_, dt);
    densityLagKept_ = densityLag_;
    if (kept_)
    {
        for (const savedField& field : savedFields("Kept"))
        {
            field.saved = field.now;
        }
    }
}


bool Foam::stepTools::restore()
{
    if (kept_)
    {
        for (const savedField& field : savedFields("Kept"))
        {
            field.now = field.saved;
        }
        densityLag_ = densityLagKept_;
    }
    return kept_;
}


void Foam::stepTools::save()
{
    for (const savedField& field : savedFields("Saved"))
    {
        field.saved = field.now;
    }
    predicting_ = true;
}


void Foam::stepTools::advanceSaved(const scalar t, const scalar dt)
{
    const auto addTo = [](const particleField& from, const scalar s, particleField& to)
    {
        for (int c = 0; c < to.nComponents(); ++c)
        {
            double* const y = to.component(c);
            const double* const x = from.component(c);

            #pragma omp parallel for schedule(static)
            for (label i = 0; i < to.size(); ++i)
            {
                y[i] += s*x[i];
            }
        }
    };

    const std::array<savedField, 3> fields(savedFields("Saved"));
    for (const savedField& field : fields)
    {
        addTo(field.now, -1, field.saved);
    }
    predicting_ = false;
    if (energyBudget* const book = budget())
    {
        book->setOffset(&fields[1].saved, &fields[2].saved);
    }

    drift(t, dt);
    advanceDensity(0, dt);
    kick(t, dt);
    for (const savedField& field : fields)
    {
        addTo(field.saved, 1, field.now);
    }
    if (energyBudget* const book = budget())
    {
        book->setOffset(nullptr, nullptr);
    }
    measureSpeed(t + dt);
    measureExcess();
}


// ************************************************************************* //
