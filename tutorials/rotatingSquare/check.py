"""Checks and figures of the rotating square: check.py <room>

The room holds a folder for each run, <mode>-L<number>. Writes figures/figures.csv for the
room runs, <room>/figures.csv for others.
"""

import pathlib
import sys

import numpy as np
from patch import MOMENTS, SURFACES, referencePressure, runs
from ulphCase import Checks
from ulphStudy import writeRows


def checkRun(run, row):
    """Bounds of the default mode; other runs are only reported."""
    name = run.folder.name
    if run.mode != "default":
        print(f"{name}: to t omega = {run.end:.3g}", end="")
        print("" if run.finished else ", stopped by itself")
        return 0

    check = Checks(name + ".")
    check("reachedTOmega", run.end, 4 if run.dx < 0.007 else 8)
    fine = run.dx < 0.015
    check("Ek(2.04)/Ek(0)", row["Ek2.04"], 0.99, 1.01)
    if 0.007 < run.dx < 0.03:
        check("Ek(8)/Ek(0)", row["Ek8"], 0.98, 1.01)
    if run.dx < 0.03:
        check("angularMomentum(4)", row["angularMomentum4"], 0.985 if fine else 0.96)
    for tOmega in MOMENTS:
        error = row[f"p{tOmega:g}"] - np.interp(tOmega, *referencePressure())
        print(f"{name}: p({tOmega:g}) = {row[f'p{tOmega:g}']:.4f}")
        if fine:
            check(f"errorOfP({tOmega:g})", error, -0.004, 0.004)
    for tOmega in SURFACES:
        if run.dx < 0.03:
            check(f"surface({tOmega})/dx", row["surface" + tOmega], 0, 0.5)
    return check.failed


if __name__ == "__main__":
    room = sys.argv[1]
    all_runs = runs(room)
    rows = [run.figures() for run in all_runs]
    failed = sum(checkRun(run, row) for run, row in zip(all_runs, rows))
    folder = pathlib.Path("figures" if room == "runs" else room)
    folder.mkdir(exist_ok=True)
    writeRows(folder / "figures.csv", rows)
    sys.exit(1 if failed else 0)
