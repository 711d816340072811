"""Checks and figures of the oscillating drop: check.py <room>

The room holds a folder for each run, <mode>-R<number>; all that have finished
are taken, and those that stopped by themselves. Writes figures/figures.csv for the
room runs, <room>/figures.csv for others.
"""

import pathlib
import sys

import numpy as np
from exact import R, Run
from ulphCase import Case, Checks
from ulphStudy import order, writeRows

# rms and largest error of the axes over R, area drift, energy change over Ek0,
# at the least these periods
BOUNDS = {
    "default-R25": (3, 0.0015, 0.005, 0.005, 0.06),
    "default-R50": (2, 0.0005, 0.0015, 0.002, 0.02),
    "default-R100": (1, 0.0002, None, None, None),
    "paper-R25": (3, 0.008, None, None, None),
    "paper-R50": (2, 0.003, None, None, None),
}


def runs(room):
    """The runs of a room that ended or stopped, coarse to fine, mode by mode."""
    found = [
        Run(log.parent)
        for log in pathlib.Path(room).glob("*-R*/log.ulphFoam")
        if Case(log.parent).finished() or "FOAM FATAL" in log.read_text()
    ]
    return sorted(found, key=lambda run: (run.mode, -run.dx))


def checkRun(run, figures):
    check = Checks(run.folder.name + ".")
    bounds = BOUNDS.get(run.folder.name, (0, None, None, None, None))
    if run.mode.startswith("paper") and bounds[0]:
        # May stop by itself; what it reaches is reported
        print(f"{run.folder.name}: {figures['periods']} of {bounds[0]} periods")
        check("rmsTwoPeriods", figures["rmsTwoPeriods"], 0, bounds[1])
    elif bounds[0]:
        check("periods", figures["periods"], bounds[0] - 0.01)
        _, rms, largest, area, energy = bounds
        if rms:
            check("rmsAxisError", figures["rmsAxisError"], 0, rms)
        if largest:
            check("maxAxisError", figures["maxAxisError"], 0, largest)
        if area:
            check("areaDrift", figures["areaDrift"], -area, area)
            check("energyChange", figures["energyChange"], -energy, energy)
    if figures["periods"] > 9.9:
        check("amplitudeKept", figures["amplitudeKept"], 0.98, 1.02)
    if not run.mode.startswith("paper"):
        check("momentum", figures["momentum"], 0, 1e-4)
        check("angularMomentum", figures["angularMomentum"], 0, 1e-4)
        check("budgetRest", figures["budgetRest"], -2e-4, 2e-4)
    return check.failed


def orders(all, check):
    """Observed order of each mode from R/12 to R/50, over two periods."""
    for mode in dict.fromkeys(run.mode for run in all):
        chosen = [r for r in all if r.mode == mode and R / 51 < r.dx < R / 11]
        errors = [run.rms(2) for run in chosen]
        if len(chosen) > 2 and np.isfinite(errors).all():
            value = order([r.dx for r in chosen], errors)
            if mode == "default":
                check("default.orderR12toR50", value, 1.2)
            else:
                print(f"{mode}: observed order R/12 to R/50 {value:.3g}")


if __name__ == "__main__":
    room = sys.argv[1]
    all_runs = runs(room)
    rows = [run.figures() for run in all_runs]
    failed = sum(checkRun(run, row) for run, row in zip(all_runs, rows))
    check = Checks()
    orders(all_runs, check)
    folder = pathlib.Path("figures" if room == "runs" else room)
    folder.mkdir(exist_ok=True)
    writeRows(folder / "figures.csv", rows)
    sys.exit(1 if failed + check.failed else 0)
