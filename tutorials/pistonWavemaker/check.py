"""Checks of the piston wave maker: check.py <room>."""

import sys

from piston import runs
from ulphCase import Checks
from ulphStudy import figuresFolder, writeRows


def main(room):
    check = Checks()
    rows = []
    for run in runs(room):
        name, row = run.folder.name + ".", run.row()
        check(name + "finished", run.case.finished(), 1, 1)
        check(name + "particlesLost", run.particles[0] - run.particles[-1], 0, 0)
        check(name + "outside", row["outside"], 0, 0)
        check(name + "volumeDrift", row["volumeDrift"], None, 0.005)
        height = 0.1 if run.dx > 0.01 else 0.05
        check(name + "height/Biesel", row["height"], 1 - height, 1 + height)
        check(name + "waveNumber/exact", row["waveNumber"], 0.98, 1.02)
        rows.append(row)
    writeRows(figuresFolder(room) / "figures.csv", rows)
    check.exit()


if __name__ == "__main__":
    main(sys.argv[1])
