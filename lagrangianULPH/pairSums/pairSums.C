// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pairSums.H"

#include "kernels.H"
#include "typedPairSums.H"

#include <map>

namespace ulph
{

namespace
{

using maker = std::unique_ptr<pairSums> (*)(bool, int, double);

const std::map<std::string, maker> makers
{
    {WendlandC2::name, makePairSums<WendlandC2>},
    {WendlandC4::name, makePairSums<WendlandC4>}
};

} // End anonymous namespace

extern template std::unique_ptr<pairSums>
makePairSums<WendlandC2>(bool, int, double);
extern template std::unique_ptr<pairSums>
makePairSums<WendlandC4>(bool, int, double);

std::unique_ptr<pairSums> pairSums::New
(
    const std::string& kernel,
    const bool mixed,
    const int D,
    const double radius
)
{
    const auto found = makers.find(kernel);
    if (found == makers.end())
    {
        throw std::invalid_argument("pair sums: unknown kernel " + kernel);
    }
    return found->second(mixed, D, radius);
}

std::vector<std::string> pairSums::kernels()
{
    std::vector<std::string> names;
    for (const auto& entry : makers)
    {
        names.push_back(entry.first);
    }
    return names;
}

} // End namespace ulph
