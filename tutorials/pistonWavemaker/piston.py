"""Runs of the piston wave maker, and what linear theory has for them.

Biesel's theory: a piston of stroke S makes waves of the height
H = S 2 (cosh 2kd - 1)/(sinh 2kd + 2kd), omega^2 = g k tanh kd, far from it.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from ulphCase import Case
from ulphStudy import bySpacing, cost, table

G, DEPTH, STROKE, PERIOD = 9.81, 0.3, 0.04, 1.0  # [m/s^2], [m], [m], [s]
GAUGES = np.array([1.2, 1.5, 1.8, 2.1])  # [m]
OMEGA = 2 * np.pi / PERIOD

# Two periods of waves that are regular, before the end of the flume sends others back
FIRST, LAST = 3.8, 5.8


def waveNumber():
    """Of linear waves of the period over the depth [1/m]."""
    k = OMEGA**2 / G
    for _ in range(100):
        k = OMEGA**2 / (G * np.tanh(k * DEPTH))
    return k


K = waveNumber()
HEIGHT = STROKE * 2 * (np.cosh(2 * K * DEPTH) - 1) / (np.sinh(2 * K * DEPTH) + 2 * K * DEPTH)


class Run:
    """A folder dx<spacing>."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.dx = float(self.folder.name.partition("dx")[2])
        self.case = Case(folder)
        elevation = table(folder, "elevation")
        self.times = elevation["Time"]
        self.levels = [elevation[f"highest_{i}"] - DEPTH for i in range(len(GAUGES))]
        clouds = [self.case.cloud(t)["x"] for t in self.case.times]
        self.particles = [len(x) for x in clouds]
        # Behind the front of the piston, or past the other walls
        piston = STROKE / 2 * np.sin(OMEGA * np.array(self.case.times))
        self.outside = sum(
            int(((x[:, 0] < p) | (x[:, 0] > 6) | (x[:, 1] < 0)).sum())
            for x, p in zip(clouds, piston)
        )

    def harmonic(self, gauge, number=1):
        """Complex amplitude [m] of a harmonic of the piston's motion at a gauge."""
        chosen = (self.times >= FIRST) & (self.times < LAST)
        t = self.times[chosen]
        parts = [np.ones_like(t)]
        for n in (1, 2, 3):
            parts += [np.cos(n * OMEGA * t), np.sin(n * OMEGA * t)]
        fit = np.linalg.lstsq(np.array(parts).T, self.levels[gauge][chosen], rcond=None)[0]
        return fit[2 * number - 1] - 1j * fit[2 * number]

    def row(self):
        first = np.array([self.harmonic(i) for i in range(len(GAUGES))])
        phase = np.unwrap(np.angle(first))
        volume = table(self.folder, "moments")["volume"]
        return {
            "dx": self.dx,
            "height": 2 * np.abs(first).mean() / HEIGHT,
            "spread": np.ptp(np.abs(first)) / np.abs(first).mean(),
            "waveNumber": -np.polyfit(GAUGES, phase, 1)[0] / K,
            "secondHarmonic": np.abs(self.harmonic(2, 2)) / np.abs(first[2]),
            "volumeDrift": float(np.abs(volume / volume[0] - 1).max()),
            "outside": self.outside,
            **cost(self.folder),
        }


def runs(room):
    """The runs of a room, coarse to fine."""
    return bySpacing(room, Run)
