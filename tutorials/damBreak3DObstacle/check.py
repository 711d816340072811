"""Checks of the dam break against a box: check.py <room>."""

import sys

import numpy as np
from obstacle import EXPERIMENT, GAUGES, IMPACT, Run
from ulphCase import Checks
from ulphStudy import bySpacing, figuresFolder, writeRows


def main(room):
    check = Checks()
    rows = []
    standing = (EXPERIMENT[:, 0] > 0.9) & (EXPERIMENT[:, 0] < 1.1)
    for run in bySpacing(room, Run):
        name, row = run.folder.name + ".", run.row()
        check(name + "finished", run.case.finished(), 1, 1)
        check(name + "particlesLost", run.particles[0] - run.particles[-1], 0, 0)
        check(name + "volumeDrift", row["volumeDrift"], None, 0.005)
        coarse = run.dx > 0.03
        check(name + "arrival1/experiment", row["arrival1"] / IMPACT[0, 1],
              0.9, 1.25 if coarse else 1.1)
        for gauge in GAUGES:
            check(f"{name}heightError{gauge}/H", row[f"heightError{gauge}"],
                  None, 0.15 if coarse else 0.1)
        if not coarse:
            check(name + "mean1/experiment",
                  row["mean1"] / np.mean(EXPERIMENT[standing, 5]), 0.8, 1.2)
        for k in range(4):
            print(f"{name}sensor {k + 1}: water at {row[f'arrival{k + 1}']:.3f} s "
                  f"(experiment {IMPACT[k, 1]:.3f}), peak {row[f'peak{k + 1}']:.0f} Pa "
                  f"({IMPACT[k, 2]:.0f})")
        rows.append(row)
    writeRows(figuresFolder(room) / "figures.csv", rows)
    check.exit()


if __name__ == "__main__":
    main(sys.argv[1])
