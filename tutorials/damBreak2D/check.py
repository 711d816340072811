"""Checks of the dam break: check.py <room> <mode>...

The room is the folder of the default mode, which holds the other modes.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from ulphCase import Case, Checks, readTable

LENGTH = 0.6  # of the column [m]
HEIGHT = 0.3
GRAVITY = 9.81
PER_SECOND = (GRAVITY / HEIGHT) ** 0.5  # T = t sqrt(g/H)

# First T and range of the front at T = 2 that each run is to reach
REACHED = {
    "default": (8, 2.1, 2.35),
    "paper": (8, 2.1, 2.35),
    "lowViscosity": (2.8, 2.3, 2.7),
    "fine": (2.4, 2.3, 2.7),
}

SURFACE_BOUNDS = {
    "airNotFlagged": 1,
    "flaggedInside": 2,
    "normalErrorMedian": 8,
    "normalErrorOf95%": 20,
}


def folder(room, mode):
    return pathlib.Path(room) / ("" if mode == "default" else mode)


def fronts(case):
    """Times T and front positions (x - 0.6 m)/H, shapes (times,).

    The front is the centre of the foremost particle and half a spacing.
    """
    dx = case.entry("dx")
    x = [case.cloud(t)["x"][:, 0].max() + dx / 2 for t in case.times]
    return np.array(case.times) * PER_SECOND, (np.array(x) - LENGTH) / HEIGHT


def frontError(reached, front):
    """Largest error of the way travelled, over it, from T = 1 to the impact."""
    here = pathlib.Path(__file__).parent
    exact = readTable(here / "reference/potential_L2H_front.csv")
    before = (reached >= 1) & (front < (1.6 - LENGTH) / HEIGHT - 0.1)
    way = np.interp(reached[before], exact[:, 0], exact[:, 1] - LENGTH / HEIGHT)
    return np.abs(front[before] / way - 1).max()


def bareArcs(x, bounds, radius, points=90):
    """Which particles see the air: an independent test of the surface flags.

    A particle does if discs of the given radius about the others, and about their
    images in the walls, leave a part of the rim of its own disc uncovered (the
    exposure test of Dilts 2000). Returns the uncovered share of the rim (n,), and
    the direction of its middle (n, 2), which is an outward normal.
    """
    all = x
    for k in (0, 1):
        for wall in bounds[k]:
            image = all[np.abs(all[:, k] - wall) < 3 * radius].copy()
            image[:, k] = 2 * wall - image[:, k]
            all = np.concatenate([all, image])

    angle = np.linspace(0, 2 * np.pi, points, endpoint=False)
    rim = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    share, normal = np.zeros(len(x)), np.zeros((len(x), 2))
    for i, centre in enumerate(x):
        apart = all - centre
        distance2 = (apart**2).sum(axis=1)
        apart = apart[(distance2 > 0) & (distance2 < 4 * radius**2)]
        bare = (rim @ apart.T * 2 * radius < (apart**2).sum(axis=1)).all(axis=1)
        there = centre + radius * rim
        bare &= np.all((there > bounds[:, 0]) & (there < bounds[:, 1]), axis=1)
        share[i] = bare.mean()
        normal[i] = rim[bare].sum(axis=0)
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    return share, normal / np.maximum(length, 1e-30)


def surface(case, T):
    """Flags and normals [degrees] against the exposure test: for each figure its
    mean over the writes within 0.04 s of T (five of the tutorial's), and its bound.
    After the wave has broken a single write is a matter of chance."""
    middle = case.nearest(T / PER_SECOND)
    writes = [surfaceAt(case, t) for t in case.times if abs(t - middle) < 0.041]
    at = f"T{T}."
    return {
        at + name: (np.mean([w[name] for w in writes]), bound)
        for name, bound in SURFACE_BOUNDS.items()
    }


def surfaceAt(case, t):
    """The figures of one write."""
    dx = case.entry("dx")
    fields = case.cloud(t)
    x, flagged = fields["x"][:, :2], fields["surface"] >= 2
    share, normal = bareArcs(x, case.bounds[:2], 1.5 * dx)
    bare = share > 0.04
    apart = np.linalg.norm(x[flagged][:, None] - x[bare], axis=2).min(axis=1)
    cosine = (fields["normal"][bare, :2] * normal[bare]).sum(axis=1)
    angle = np.degrees(np.arccos(np.clip(cosine, -1, 1)))

    print(
        f"T = {t * PER_SECOND:.2f}: {bare.sum()} particles see the air, "
        f"{flagged.sum()} are flagged"
    )
    return {
        "airNotFlagged": (bare & ~flagged).sum(),
        "flaggedInside": (apart > 1.5 * dx).sum(),
        "normalErrorMedian": np.median(angle),
        "normalErrorOf95%": np.percentile(angle, 95),
    }


def checkRun(case, mode, test):
    check = Checks(mode + ".")
    reached, front = fronts(case)
    end, low, high = REACHED[mode]
    if test and mode in ("default", "paper"):
        end = 2.2

    check("finished", case.finished(), 1, 1)
    check("lastT", reached[-1], end)
    check("frontAtT2", np.interp(2, reached, front), low, high)
    if mode == "fine":
        check("frontError", frontError(reached, front), None, 0.03)

    first = len(case.cloud(0)["x"])
    lost = outside = bad = 0
    for t in case.times:
        fields = case.cloud(t)
        x = fields["x"][:, :2]
        bounds = case.bounds[:2]
        outside += np.any((x < bounds[:, 0]) | (x > bounds[:, 1]), axis=1).sum()
        lost = max(lost, abs(len(x) - first))
        bad += sum(np.size(f) - np.isfinite(f).sum() for f in fields.values())
    check("particles", first, round(LENGTH * HEIGHT / case.entry("dx") ** 2), first)
    check("particlesLostOrMade", lost, 0, 0)
    check("outsideTheTank", outside, 0, 0)
    check("valuesNotFinite", bad, 0, 0)
    for T in (2.06, 5.72):
        if mode in ("default", "paper") and reached[-1] >= T:
            for name, (value, bound) in surface(case, T).items():
                check(name, value, 0, bound)
    print(f"{mode} took {case.executionTime():.1f} s of CPU time")
    return check.failed


if __name__ == "__main__":
    room, *modes = sys.argv[1:]
    failed = [checkRun(Case(folder(room, m)), m, room == "test") for m in modes]
    sys.exit(1 if any(failed) else 0)
