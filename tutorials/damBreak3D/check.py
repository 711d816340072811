"""Checks of the dam break in three dimensions: check.py <room>."""

import sys

from dam import FINITE_VOLUME, PRESSURES, delay, impact, plateau, runs
from ulphCase import Checks
from ulphStudy import figuresFolder, writeRows


def checkPressures(check, name, row, friction):
    """Against experiment and interFoam, at the resolution that the bounds are for."""
    arrival = impact(PRESSURES[0][:, 0], PRESSURES[0][:, 2]) - delay()
    hit = row["impact"] - row["delay"]
    check(name + "impact/experiment", hit / arrival, 0.97, 1.03)
    check(name + "noise1", row["noise1"], None, 0.05)
    for k in (1, 2):
        t, low, median, high = PRESSURES[k - 1].T
        check(name + f"peak{k}", row[f"peak{k}"], low.max(), high.max())
        ratio = row[f"plateau{k}"] / plateau(t, median)
        check(name + f"plateau{k}/median", ratio, 0.85, 1.15)
        if not friction:
            ratio = row[f"plateau{k}"] / plateau(FINITE_VOLUME[:, 0], FINITE_VOLUME[:, k])
            check(name + f"plateau{k}/interFoam", ratio, 0.85, 1.15)


def main(room):
    check = Checks()
    rows = []
    found, others = runs(room)
    for run in found + others:
        name, row = run.folder.name + ".", run.row()
        check(name + "finished", run.case.finished(), 1, 1)
        check(name + "particlesLost", run.particles[0] - run.particles[-1], 0, 0)
        check(name + "outsideTheTank", run.outside, 0, 0)
        check(name + "volumeDrift", row["volumeDrift"], None, 0.005)
        if run.high:
            check(name + "lid", run.case.bounds[2][1], 1.199, 1.201)
        if run.dx <= 0.01:
            if not run.friction:
                check(name + "frontError", row["frontError"], None, 0.03)
            checkPressures(check, name, row, run.friction)
        elif not run.high:
            # Bounds of the coarse form: viscosity grows with dx and holds the front
            check(name + "frontError", row["frontError"], None, 0.25)
            check(name + "impact", row["impact"], 2.2, 2.8)
        rows.append(row)
    writeRows(figuresFolder(room) / "figures.csv", rows)
    check.exit()


if __name__ == "__main__":
    main(sys.argv[1])
