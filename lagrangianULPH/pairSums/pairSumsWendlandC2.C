// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

#include "makePairSums.H"

template std::unique_ptr<ulph::pairSums>
ulph::makePairSums<ulph::WendlandC2>(bool, int, double);
