"""Runs of the dam break in three dimensions: front, sensors, references.

Lengths are over the height H of the column, times over sqrt(H/g), pressures over
rho g H.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from ulphCase import Case, readTable
from ulphStudy import bySpacing, cost, table

TANK, WIDTH = 1.61, 0.15  # [m]
SENSORS = (0.003, 0.015, 0.03, 0.08)  # heights on the downstream wall [m]

POTENTIAL = readTable("reference/potential_L2H_front.csv")
FRONT = readTable("reference/lobovsky2014_front_H300.csv")
PRESSURES = [
    readTable(f"reference/lobovsky2014_H300_sensor{k}.csv") for k in (1, 2)
]
# Pressures of two-phase finite-volume solutions in 2D, with slip walls, and turbulent
# with friction at the walls
FINITE_VOLUME = readTable("reference/interFoam_slip_sensors.csv")
TURBULENT = readTable("reference/interFoam_turbulent_sensors.csv")


def plateau(t, p):
    """Mean of the pressure p from t = 3 to 5."""
    return p[(t >= 3) & (t <= 5)].mean()


def delay(times=FRONT[:, 0], front=FRONT[:, 1]):
    """How much later than in potential flow a front arrives, that of the experiment.

    The gate takes time to open: mean over the places from 1 to 2.5 H downstream.
    """
    places = np.linspace(1, 2.5, 30)
    late = np.interp(places, front, times)
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
    """A folder dx<spacing>, logLaw-dx<spacing>, or H600-dx<spacing>."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.high = self.folder.name.startswith("H600")
        self.friction = self.folder.name.startswith("logLaw")
        self.H = 0.6 if self.high else 0.3  # [m]
        self.perSecond = np.sqrt(9.81 / self.H)
        self.unit = 1000 * 9.81 * self.H  # [Pa]
        self.dx = float(self.folder.name.partition("dx")[2])
        self.case = Case(folder)
        clouds = [self.case.cloud(t)["x"] for t in self.case.times]
        self.particles = [len(x) for x in clouds]
        self.outside = sum(self.countOutside(x) for x in clouds)
        front = table(folder, "front")
        self.frontTimes = front["Time"] * self.perSecond
        self.front = front["front"] / self.H
        sensors = table(folder, "sensors")
        self.times = sensors["Time"] * self.perSecond
        self.pressures = [sensors[f"p_{k}"] / self.unit for k in range(len(SENSORS))]
        # On the downstream wall, over rho g H^2 times its width
        force = table(folder, "forces", "force")["total_x"]
        self.force = force / (self.unit * self.H * WIDTH)

    def countOutside(self, x):
        low, high = self.case.bounds[:, 0], self.case.bounds[:, 1]
        return int(((x < low) | (x > high)).any(axis=1).sum())

    def frontError(self):
        """Largest error of the distance travelled, over it, from t = 1 to the impact."""
        if self.high:
            return np.nan  # potential flow is known for L = 2 H alone
        before = (self.front < TANK / self.H - 0.1) & (self.frontTimes > 1)
        t = self.frontTimes[before]
        exact = np.interp(t, POTENTIAL[:, 0], POTENTIAL[:, 1])
        return np.abs((self.front[before] - exact) / (exact - 2)).max()

    def delay(self):
        """Likewise of this run; only friction at the walls has a reason for one."""
        before = self.front < TANK / self.H - 0.1
        return delay(self.frontTimes[before], self.front[before] - 2)

    def row(self):
        volume = table(self.folder, "moments")["volume"]
        row = {
            "run": self.folder.name,
            "dx": self.dx,
            "end": float(self.times[-1]),
            "frontError": float(self.frontError()),
            "delay": float(self.delay()) if self.friction else 0.0,
            "impact": float(impact(self.times, self.pressures[0])),
            "noise1": float(noise(self.times, self.pressures[0])),
            "volumeDrift": float(np.abs(volume / volume[0] - 1).max()),
            "outside": self.outside,
            "peakForce": float(self.force.max()),
        }
        for k in range(len(SENSORS)):
            row[f"peak{k + 1}"] = float(self.pressures[k].max())
            row[f"plateau{k + 1}"] = float(plateau(self.times, self.pressures[k]))
        return {**row, **cost(self.folder)}


def runs(room):
    """The runs with H = 0.3 m, coarse to fine, and others: friction, and H = 0.6 m."""
    others = sorted(pathlib.Path(room).glob("*-dx*"), reverse=True)
    return bySpacing(room, Run), [Run(folder) for folder in others]
