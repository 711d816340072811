"""Runs of the dam break against a box, and the experiment, in SI units."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from ulphCase import Case, readTable
from ulphStudy import cost, table

HEIGHT = 0.55  # of the column [m]
UNIT = 1000 * 9.81 * HEIGHT  # [Pa]
GAUGES = (0.496, 0.992, 1.488, 2.638)  # x [m]

# Time [s], heights at the gauges [m], pressure of sensor 1 [Pa]
EXPERIMENT = readTable("reference/kleefsman2005.csv")
# Sensor, time of arrival [s], peak to 0.5 s [Pa]
IMPACT = readTable("reference/impact.csv")


class Run:
    """A folder dx<spacing>."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.dx = float(self.folder.name[2:])
        self.case = Case(folder)
        self.particles = [len(self.case.cloud(t)["x"]) for t in self.case.times]

        gauges = table(folder, "gauges")
        self.gaugeTimes = gauges["Time"]
        # Wet from the floor up to the highest surface, as the wires show it
        self.heights = [np.maximum(gauges[f"highest_{k}"], 0) for k in range(4)]

        sensors = table(folder, "sensors")
        self.times = sensors["Time"]
        top = table(folder, "topSensors")
        self.pressures = [four[f"p_{k}"] for four in (sensors, top) for k in range(4)]
        forces = table(folder, "forces", "force")
        # Along the flow, which runs against x [N]
        self.forceTimes, self.force = forces["Time"], -forces["total_x"]

    def heightError(self, k):
        """Mean over the experiment's times of the error at gauge k, over H."""
        t, exact = EXPERIMENT[:, 0], EXPERIMENT[:, 1 + k]
        inside = t <= self.gaugeTimes[-1]
        there = np.interp(t[inside], self.gaugeTimes, self.heights[k])
        return float(np.abs(there - exact[inside]).mean() / HEIGHT)

    def arrival(self, k):
        """When sensor k + 1 first shows 1 kPa [s]; nan where it does not."""
        over = np.flatnonzero(self.pressures[k] > 1000)
        return float(self.times[over[0]]) if len(over) else float("nan")

    def row(self):
        volume = table(self.folder, "moments")["volume"]
        early = self.times < 0.5
        row = {
            "run": self.folder.name,
            "dx": self.dx,
            "end": float(self.times[-1]),
            "volumeDrift": float(np.abs(volume / volume[0] - 1).max()),
            "peakForce": float(self.force.max()),
        }
        for k in range(4):
            row[f"heightError{GAUGES[k]}"] = self.heightError(k)
        for k in range(4):
            row[f"arrival{k + 1}"] = self.arrival(k)
            row[f"peak{k + 1}"] = float(self.pressures[k][early].max())
        for k in range(4, 8):
            row[f"largest{k + 1}"] = float(self.pressures[k].max())
        # Of sensor 1 while the water stands before the box
        standing = (self.times > 0.9) & (self.times < 1.1)
        row["mean1"] = (
            float(self.pressures[0][standing].mean()) if standing.any() else float("nan")
        )
        return {**row, **cost(self.folder)}
