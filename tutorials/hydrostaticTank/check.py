"""Checks of the still tanks: check.py <room>, the folder of the four runs."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from rest import GRAVITY, LEVEL, areaAndHeight, levelOf
from ulphCase import Case, Checks

TANKS = ("upright", "turned", "step", "cylinder")

# Ek/Ep, rms pressure error/(rho g H), centroid drift/H
BOUNDS = {"upright": (5e-6, 0.01, 0.001)}
OTHERS = (5e-5, 0.02, 0.002)

# The fill does not fit turned and curved walls: it settles first
SETTLED = 5.0  # [s]


class Tank:
    """A run: its times [s], and what is checked at each of them."""

    def __init__(self, folder):
        self.case = case = Case(folder)
        self.name = pathlib.Path(folder).name
        self.times = np.array(case.times)
        self.unit = case.entry("rho0") * GRAVITY * LEVEL

        first = case.cloud(0)
        self.particles = len(first["x"])
        density = case.entry("rho0") + first["densityExcess"]
        self.level = levelOf(self.name, (first["mass"] / density).sum())
        self.height = areaAndHeight(self.name, self.level)[1]
        self.asked = areaAndHeight(self.name, LEVEL)[0]

        rows = [self.figures(case.cloud(t)) for t in case.times]
        self.energy, self.pressure, self.offset, self.y, lost = np.array(rows).T
        self.lost = lost.max()
        self.drift = (self.y - self.y[np.argmax(self.times >= self.start())]) / LEVEL

    def start(self):
        """The time from which the figures are taken [s]."""
        settled = 0 if self.name in ("upright", "step") else SETTLED
        return min(settled, 0.75 * self.times[-1])

    def figures(self, fields):
        """Ek/Ep, rms and mean pressure error, height of the centroid, lost."""
        y = fields["x"][:, 1]
        m = fields["mass"]
        kinetic = 0.5 * (m * (fields["U"] ** 2).sum(axis=1)).sum()
        potential = GRAVITY * (m * y).sum()
        error = fields["p"] / self.unit - (self.level - y) / LEVEL
        return (
            kinetic / potential,
            np.sqrt((error**2).mean()),
            error.mean(),
            (m * y).sum() / m.sum(),
            self.particles - len(y),
        )


def checkTank(tank):
    """The largest figures since the start, or since the fill has settled."""
    check = Checks(tank.name + ".")
    energy, pressure, drift = BOUNDS.get(tank.name, OTHERS)
    since = tank.times >= tank.start()

    check("finished", tank.case.finished(), 1, 1)
    check("Ek/Ep", tank.energy[since].max(), 0, energy)
    check("pressureError", tank.pressure[since].max(), 0, pressure)
    check("centroidDrift", np.abs(tank.drift[since]).max(), 0, drift)
    check("particlesLost", tank.lost, 0, 0)
    print(
        f"{tank.name}: {tank.particles} particles, level {tank.level:.4f} m of the "
        f"particles' volume ({tank.level - LEVEL:+.4f} m to that asked for); centroid "
        f"{(tank.y[0] - tank.height) / LEVEL:+.2e} H at the start, "
        f"{(tank.y[-1] - tank.height) / LEVEL:+.2e} H at the end from that of rest; "
        f"{tank.case.executionTime():.1f} s of CPU time"
    )
    return check.failed


if __name__ == "__main__":
    room = pathlib.Path(sys.argv[1])
    failed = [checkTank(Tank(room / name)) for name in TANKS]
    sys.exit(1 if any(failed) else 0)
