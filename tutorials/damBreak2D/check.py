"""Checks of the dam break: check.py <room> <mode>...

The room is the folder of the default mode, which holds the other modes.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from ulphCase import Case, Checks

LENGTH = 0.6  # of the column [m]
HEIGHT = 0.3
GRAVITY = 9.81
PER_SECOND = (GRAVITY / HEIGHT) ** 0.5  # T = t sqrt(g/H)


def folder(room, mode):
    return pathlib.Path(room) / ("" if mode == "default" else mode)


def fronts(case):
    """Times T and front positions (x - 0.6 m)/H, shapes (times,).

    The front is the centre of the foremost particle and half a spacing.
    """
    dx = case.entry("dx")
    x = [case.cloud(t)["x"][:, 0].max() + dx / 2 for t in case.times]
    return np.array(case.times) * PER_SECOND, (np.array(x) - LENGTH) / HEIGHT


def checkRun(case, mode, test):
    check = Checks(mode + ".")
    T, front = fronts(case)
    if mode == "lowViscosity":
        end, low, high = 2.8, 2.3, 2.7
    else:
        end, low, high = 2.2 if test else 8, 2.1, 2.35

    check("finished", case.finished(), 1, 1)
    check("lastT", T[-1], end)
    check("frontAtT2", np.interp(2, T, front), low, high)

    first = len(case.cloud(0)["x"])
    lost = outside = bad = 0
    for t in case.times:
        fields = case.cloud(t)
        x = fields["x"][:, :2]
        bounds = case.bounds[:2]
        outside += np.any((x < bounds[:, 0]) | (x > bounds[:, 1]), axis=1).sum()
        lost = max(lost, abs(len(x) - first))
        bad += sum(np.size(f) - np.isfinite(f).sum() for f in fields.values())
    check("times", len(case.times), 2)
    check("particles", first, round(LENGTH * HEIGHT / case.entry("dx") ** 2), first)
    check("particlesLostOrMade", lost, 0, 0)
    check("outsideTheTank", outside, 0, 0)
    check("valuesNotFinite", bad, 0, 0)
    print(f"{mode} took {case.executionTime():.1f} s of CPU time")
    return check.failed


if __name__ == "__main__":
    room, *modes = sys.argv[1:]
    failed = [checkRun(Case(folder(room, m)), m, room == "test") for m in modes]
    sys.exit(1 if any(failed) else 0)
