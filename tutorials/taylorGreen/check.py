"""Checks of the Taylor-Green vortices: check.py <room>."""

import sys

from vortices import runs
from ulphCase import Checks
from ulphStudy import order


def main(room):
    check = Checks()
    found = [run for run in runs(room) if run.mode == "default"]
    for run in found:
        finished = "\nEnd\n" in (run.folder / "log.ulphFoam").read_text()
        check(run.folder.name + ".finished", finished, 1, 1)
        # Half the particles per side and less: for the order
        bound = {25: None, 50: 0.05, 100: 0.03}[run.n]
        if bound:
            name = run.folder.name + ".effective/askedViscosity"
            check(name, run.viscosity, 1 - bound, 1 + bound)
    for Re in sorted({run.Re for run in found}):
        group = [run for run in found if run.Re == Re]
        slope = order([1 / r.n for r in group], [r.lateError for r in group])
        check(f"Re{Re}.orderOfVelocityError", slope, 1)
    check.exit()


if __name__ == "__main__":
    main(sys.argv[1])
