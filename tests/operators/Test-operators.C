/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    Test-operators

Description
    Checks of pair lists, pair sums and the right-hand side against the printed
    equations. Runs in the folder that holds the meshed cases; prints one line
    per check and returns 1 when one fails. An argument names the only group to
    run.

\*---------------------------------------------------------------------------*/

#include "checks.H"

#include <iostream>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    using namespace Foam;

    const struct
    {
        const char* name;
        void (*run)(tally&);
    } groups[] =
    {
        {"tensor", tensorChecks},
        {"kernel", kernelChecks},
        {"list", listChecks},
        {"longList", longListChecks},
        {"pairSum", pairSumChecks},
        {"model", modelChecks},
        {"contact", contactChecks},
        {"operator", operatorChecks},
        {"symmetry", symmetryChecks},
        {"precision", precisionChecks}
    };

    tally t;
    for (const auto& group : groups)
    {
        if (argc < 2 || argv[1] == std::string(group.name))
        {
            group.run(t);
        }
    }
    std::cout<< t.nPassed << " passed, " << t.nFailed << " failed" << std::endl;

    return t.nFailed || !t.nPassed ? 1 : 0;
}


// ************************************************************************* //
