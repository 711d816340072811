"""Checks of the sloshing tank: check.py <room>."""

import sys

from tank import runs
from ulphCase import Case, Checks
from ulphStudy import figuresFolder, writeRows

# Bounds of the error of the crests [s], relative, by spacing; coarse is the short
# form's own
CRESTS = {0.02: (0.06, 0.15), 0.01: (0.03, 0.05), 0.005: (0.03, 0.05)}

LARGEST_DIFFERENCE = 0.01


def main(room):
    check = Checks()
    rows = []
    found = runs(room)
    fixed = {(run.deep, run.dx): run for run in found if run.what[5:] in ("0.5", "0.6")}
    for run in found:
        case, row = Case(run.folder), run.row()
        name = run.folder.name + "."
        check(name + "finished", case.finished(), 1, 1)
        lost = row["particles"] - len(case.cloud(0)["x"])
        check(name + "particlesLost", lost, 0, 0)
        check(name + "volumeDrift", row["volumeDrift"], None, 0.005)
        if run.what == "depth0.5":
            late, low = CRESTS[run.dx]
            for k in (1, 2, 3):
                check(name + f"crest{k}.time", row[f"crest{k}Time"], -late, late)
                check(name + f"crest{k}.height", row[f"crest{k}Height"], -low, low)
        if run.deep:
            check(name + "rms/largest", row["rms"], None, 0.05)
        if run.started:
            check(name + "rms/largest.experiment", row["rmsExperiment"], None, 0.12)
        smooth = apart = float("nan")
        if run.movingWalls or run.nudged:
            smooth, apart = run.differences(fixed[run.deep, run.dx])
        if run.movingWalls:
            check(name + "difference", smooth, None, LARGEST_DIFFERENCE)
            check(name + "differenceAtLast", apart, None, LARGEST_DIFFERENCE)
        rows.append({**row, "difference": smooth, "differenceAtLast": apart})
    writeRows(figuresFolder(room) / "figures.csv", rows)
    check.exit()


if __name__ == "__main__":
    main(sys.argv[1])
