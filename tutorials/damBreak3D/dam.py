"""Runs of the dam break in three dimensions: front, sensors, references.

Lengths are over H = 0.3 m, times over sqrt(H/g), pressures over rho g H.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from ulphCase import Case, readTable
from ulphStudy import cost, table

HEIGHT, LENGTH, TANK = 0.3, 0.6, 1.61  # of the column and of the tank [m]
WIDTH = 0.15  # [m]
PER_SECOND = np.sqrt(9.81 / HEIGHT)
UNIT = 1000 * 9.81 * HEIGHT  # [Pa]
SENSORS = (0.003, 0.015, 0.03, 0.08)  # heights on the downstream wall [m]

POTENTIAL = readTable("reference/potential_L2H_front.csv")
FRONT = readTable("reference/lobovsky2014_front_H300.csv")
PRESSURES = [
    readTable(f"reference/lobovsky2014_H300_sensor{k}.csv") for k in (1, 2)
]


def delay():
    """How much later than in potential flow the experiment's front arrives.

    The gate takes time to open: mean over the places from 1 to 2.5 H downstream.
    """
    places = np.linspace(1, 2.5, 30)
    late = np.interp(places, FRONT[:, 1], FRONT[:, 0])
    return (late - np.interp(places, POTENTIAL[:, 1] - 2, POTENTIAL[:, 0])).mean()


def impact(t, p):
    """When a pressure first passes 0.3 [rho g H]; nan where it does not."""
    over = np.flatnonzero(p > 0.3)
    return t[over[0]] if len(over) else np.nan


def noise(t, p, first=3, last=6, window=0.1):
    """Root mean square of p about its running mean."""
    even = np.arange(first - window, min(last, t[-1]) + window, window / 50)
    values = np.interp(even, t, p)
    mean = np.convolve(values, np.full(50, 1 / 50), "same")
    inside = (even >= first) & (even <= last)
    return np.sqrt(((values - mean)[inside] ** 2).mean())


class Run:
    """A folder dx<spacing>."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.dx = float(self.folder.name[2:])
        self.case = Case(folder)
        clouds = [self.case.cloud(t)["x"] for t in self.case.times]
        self.particles = [len(x) for x in clouds]
        self.outside = sum(self.countOutside(x) for x in clouds)
        front = table(folder, "front")
        self.frontTimes = front["Time"] * PER_SECOND
        self.front = front["front"] / HEIGHT
        sensors = table(folder, "sensors")
        self.times = sensors["Time"] * PER_SECOND
        self.pressures = [sensors[f"p_{k}"] / UNIT for k in range(len(SENSORS))]
        # On the downstream wall, over rho g H^2 times its width
        force = table(folder, "forces", "force")["total_x"]
        self.force = force / (UNIT * HEIGHT * WIDTH)

    def countOutside(self, x):
        low, high = self.case.bounds[:, 0], self.case.bounds[:, 1]
        return int(((x < low) | (x > high)).any(axis=1).sum())

    def frontError(self):
        """Largest error of the distance travelled, over it, from t = 1 to the impact."""
        before = (self.front < TANK / HEIGHT - 0.1) & (self.frontTimes > 1)
        t = self.frontTimes[before]
        exact = np.interp(t, POTENTIAL[:, 0], POTENTIAL[:, 1])
        return np.abs((self.front[before] - exact) / (exact - 2)).max()

    def row(self):
        volume = table(self.folder, "moments")["volume"]
        row = {
            "run": self.folder.name,
            "dx": self.dx,
            "end": float(self.times[-1]),
            "frontError": float(self.frontError()),
            "impact": float(impact(self.times, self.pressures[0])),
            "noise1": float(noise(self.times, self.pressures[0])),
            "volumeDrift": float(np.abs(volume / volume[0] - 1).max()),
            "outside": self.outside,
            "peakForce": float(self.force.max()),
        }
        plateau = (self.times >= 3) & (self.times <= 5)
        for k in range(len(SENSORS)):
            row[f"peak{k + 1}"] = float(self.pressures[k].max())
            row[f"plateau{k + 1}"] = float(self.pressures[k][plateau].mean())
        return {**row, **cost(self.folder)}
