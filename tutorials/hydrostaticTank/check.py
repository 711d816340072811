"""Checks and figures of the still tanks: check.py <room>, the folder of the four
runs. Writes figures/figures.csv for the room runs, <room>/figures.csv for others.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from rest import GRAVITY, LEVEL, areaAndHeight
from ulphCase import Case, Checks
from ulphStudy import cost, figuresFolder, writeRows

TANKS = ("upright", "turned", "step", "cylinder")

# Ek/Ep, rms pressure error/(rho g H), centroid drift/H
BOUNDS = {"upright": (5e-6, 0.01, 0.001)}
OTHERS = (5e-5, 0.02, 0.002)


class Tank:
    """A run: its times [s], and what is checked at each of them."""

    def __init__(self, folder):
        self.case = case = Case(folder)
        self.name = pathlib.Path(folder).name
        self.times = np.array(case.times)
        self.unit = case.entry("rho0") * GRAVITY * LEVEL
        tank = self.name.removeprefix("paper-")
        self.area, self.height = areaAndHeight(tank, LEVEL)

        first = case.cloud(0)
        self.particles = len(first["x"])
        density = case.entry("rho0") + first["densityExcess"]
        self.filled = (first["mass"] / density).sum()

        rows = [self.figures(case.cloud(t)) for t in case.times]
        self.energy, self.pressure, self.y, lost = np.array(rows).T
        self.lost = lost.max()
        self.drift = (self.y - self.y[0]) / LEVEL

    def figures(self, fields):
        """Ek/Ep, rms pressure error, height of the centroid, lost particles."""
        y, m = fields["x"][:, 1], fields["mass"]
        kinetic = 0.5 * (m * (fields["U"] ** 2).sum(axis=1)).sum()
        potential = GRAVITY * (m * y).sum()
        error = fields["p"] / self.unit - (LEVEL - y) / LEVEL
        return (
            kinetic / potential,
            np.sqrt((error**2).mean()),
            (m * y).sum() / m.sum(),
            self.particles - len(y),
        )

    def row(self):
        """The largest of all writes, and what they cost."""
        return {
            "tank": self.name,
            "dx": self.case.entry("dx"),
            "end": self.times[-1],
            "EkByEp": self.energy.max(),
            "pressureError": self.pressure.max(),
            "centroidDrift": np.abs(self.drift).max(),
            "particlesLost": int(self.lost),
            "EkByEpAtEnd": self.energy[-1],
            "areaError": self.filled / self.area - 1,
            "centroidOfRest": (self.y[-1] - self.height) / LEVEL,
            **cost(self.case.folder),
        }


def report(tank, row):
    print(
        f"{tank.name}: Ek/Ep {row['EkByEp']:.2e}, pressure error "
        f"{row['pressureError']:.4f}, drift {row['centroidDrift']:.1e}, lost "
        f"{row['particlesLost']}, to {row['end']:g} s"
    )


def checkTank(tank, row):
    check = Checks(tank.name + ".")
    energy, pressure, drift = BOUNDS.get(tank.name, OTHERS)

    check("finished", tank.case.finished(), 1, 1)
    check("Ek/Ep", row["EkByEp"], 0, energy)
    check("pressureError", row["pressureError"], 0, pressure)
    check("centroidDrift", row["centroidDrift"], 0, drift)
    check("particlesLost", row["particlesLost"], 0, 0)
    print(
        f"{tank.name}: {tank.particles} particles, their area {row['areaError']:+.1e} "
        f"off that asked for; centroid at the end {row['centroidOfRest']:+.1e} H "
        f"off that of rest; {row['cpuSeconds']:.1f} s of CPU time"
    )
    return check.failed


if __name__ == "__main__":
    room = pathlib.Path(sys.argv[1])
    tanks = [Tank(room / name) for name in TANKS]
    rows = [tank.row() for tank in tanks]
    failed = [checkTank(tank, row) for tank, row in zip(tanks, rows)]
    # Paper mode is reported, not held to the bounds
    for name in TANKS:
        if (room / f"paper-{name}").is_dir():
            tank = Tank(room / f"paper-{name}")
            rows.append(tank.row())
            report(tank, rows[-1])
    writeRows(figuresFolder(room) / "figures.csv", rows)
    sys.exit(1 if any(failed) else 0)
