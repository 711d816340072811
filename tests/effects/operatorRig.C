// ulphFoam: free-surface flow by updated Lagrangian particle hydrodynamics
// SPDX-License-Identifier: GPL-3.0-or-later

// Description
//     Particles and right-hand side set up as for the checks of the operators

#include "../operators/checks.C"
#include "../operators/particleSample.C"
#include "../operators/rig.C"
#include "../operators/scenes.C"
