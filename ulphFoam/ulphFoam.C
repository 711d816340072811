/*---------------------------------------------------------------------------*\
    ulphFoam: free-surface flow with updated Lagrangian particles
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    ulphFoam

Description
    Free-surface flow by updated Lagrangian particle hydrodynamics.

    Reads constant/ulphProperties, constant/g and the mesh, and writes the
    cloud lagrangian/fluid. With -dry-run it checks the case, writes the
    particles of the start and predicts what the run will take.

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "sigFpe.H"
#include "ulphSolver.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Free-surface flow by updated Lagrangian particle hydrodynamics"
    );

    argList::addBoolOption
    (
        "dry-run",
        "Check the case, write the particles of the start, predict the run"
    );

    #include "setRootCaseLists.H"

    // The guard finds what is not finite, says where, and writes the state;
    // OpenFOAM's trap would only end the run
    sigFpe::unset(true);

    // Not createMesh.H: its dry run makes a mesh of one column
    Time runTime(Time::controlDictName, args);
    fvMesh mesh(ulphSolver::meshObject(runTime));

    ulphSolver solver(runTime, mesh);

    if (args.found("dry-run"))
    {
        solver.predict();
        solver.write(true);
        Info<< "End" << nl << endl;
        return 0;
    }

    if (runTime.value() == 0)
    {
        solver.evaluate();
        solver.write(true);
    }

    Info<< "Starting time loop" << nl << endl;

    while (runTime.run())
    {
        solver.setDeltaT();

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl;

        solver.advance();
        solver.info();
        solver.write();
        runTime.write();

        runTime.printExecutionTime(Info);
    }

    solver.report();

    Info<< "End" << nl << endl;

    return 0;
}


// ************************************************************************* //
