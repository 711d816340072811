/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Places in the rows behind wallSheets.

\*---------------------------------------------------------------------------*/

#include "wallSheets.H"
#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::wallSheets::visitLevels
(
    const label sheeti,
    const label layer,
    const point& foot,
    const scalar step,
    const bool extended,
    const boundBox& bb,
    const siteVisitor& visit
) const
{
    const sheet& s = sheets_[sheeti];
    const scalar radius = 0.5*bb.mag();
    const scalar centre = bb.midpoint() & s.axis;

    std::size_t i =
        std::lower_bound(s.level.begin(), s.level.end(), centre - radius)
      - s.level.begin();

    for (; i < s.level.size() && s.level[i] <= centre + radius; ++i)
    {
        const point p(foot + s.level[i]*s.axis);

        if (bb.contains(p))
        {
            visit
            ({
                p,
                step*dx_*s.levelStep[i],
                sheeti,
                layer,
                extended || s.levelExtended[i]
            });
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::wallSheets::forSites
(
    const boundBox& bb,
    const siteVisitor& visit
) const
{
    const point centre(bb.midpoint());
    const scalar radius = 0.5*bb.mag();
    const vector reach(vector::uniform(nLayers_*std::sqrt(scalar(3))*dx_));

    for (label sheeti = 0; sheeti < size(); ++sheeti)
    {
        const sheet& s = sheets_[sheeti];
        const label nSegments = label(s.tangent.size());

        const boundBox around(s.bounds.min() - reach, s.bounds.max() + reach);

        if (!bb.overlaps(around)) continue;

        for (label i = 0; i < nSegments; ++i)
        {
            const vector& tangent = s.tangent[i];
            const scalar height = (centre - s.corner[i]) & s.normal[i];

            for (label layer = 0; layer < nLayers_; ++layer)
            {
                const scalar offset = (layer + 0.5)*dx_;

                if (std::abs(height - offset) > radius) continue;

                const point begin(s.corner[i] + offset*s.miter[i]);
                const scalar middle = (centre - begin) & tangent;

                if (s.nAlong[layer])
                {
                    const scalar step = s.along[layer].back()/s.nAlong[layer];
                    const scalar from = s.along[layer][i];
                    const scalar to = s.along[layer][i + 1];

                    const scalar low = Foam::max(from, from + middle - radius);
                    const scalar high = Foam::min(to, from + middle + radius);

                    for
                    (
                        label j = label(std::floor(low/step - 0.5));
                        (j + 0.5)*step < high;
                        ++j
                    )
                    {
                        if ((j + 0.5)*step < low) continue;

                        visitLevels
                        (
                            sheeti,
                            layer,
                            begin + ((j + 0.5)*step - from)*tangent,
                            step,
                            false,
                            bb,
                            visit
                        );
                    }
                }

                if (s.closed) continue;

                for (label j = 0; j < nLayers_; ++j)
                {
                    const vector past((j + 0.5)*dx_*tangent);

                    if (i == 0)
                    {
                        visitLevels
                        (
                            sheeti, layer, begin - past, dx_, true, bb, visit
                        );
                    }

                    if (i == nSegments - 1)
                    {
                        visitLevels
                        (
                            sheeti,
                            layer,
                            s.corner.back() + offset*s.miter.back() + past,
                            dx_,
                            true,
                            bb,
                            visit
                        );
                    }
                }
            }
        }
    }
}


// ************************************************************************* //
