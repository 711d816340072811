"""Runs of the sloshing tank: elevations at the gauges, references, crests."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from ulphCase import readTable
from ulphStudy import cost, table

POTENTIAL = readTable("reference/potential_h0.5_T1.875_A0.032_L1.72.csv")
DEEP_POTENTIAL = readTable("reference/potential_h0.6_T1.3_A0.032_L1.73.csv")
EXPERIMENT = readTable("reference/faltinsen2000_h0.6_T1.3_A0.032.csv")
STARTED_POTENTIAL = readTable("reference/potential_h0.6_started.csv")
STARTED_EARLIER = 1.3 / 4  # than the record of the experiment [s]
BREAKS = 7  # the wave of depth 0.5 m [s]
GAUGES = (0.05, 0.5)  # from the left wall [m]


def crests(t, eta, number=3):
    """Times and heights of the first crests higher than 0.03 m, shape (n, 2)."""
    found = []
    for i in range(1, len(t) - 1):
        window = np.abs(t - t[i]) < 0.4
        if eta[i] > 0.03 and eta[i] == eta[window].max():
            if not found or t[i] - found[-1][0] > 0.4:
                found.append((t[i], eta[i]))
    return np.array(found[:number]).reshape(-1, 2)


class Run:
    """A folder <what>-dx<spacing>."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.what, _, spacing = self.folder.name.partition("-dx")
        self.dx = float(spacing)
        self.deep = self.what.startswith("depth0.6")
        self.started = self.what.endswith("Started")
        self.movingWalls = self.what.lower().endswith("movingwalls")
        self.nudged = self.what == "nudged"
        self.depth = 0.6 if self.deep else 0.5
        columns = table(folder, "elevation")
        self.times = columns["Time"]
        self.elevations = [columns[f"highest_{k}"] - self.depth for k in (0, 1)]
        self.moments = table(folder, "moments")

    def crestErrors(self):
        """Error of time [s] and relative error of height, first crests at gauge 0."""
        exact = crests(POTENTIAL[:, 0], POTENTIAL[:, 1])
        rows = []
        for t, height in exact:
            near = np.abs(self.times - t) < 0.3
            if not near.any() or self.times[-1] < t + 0.1:
                continue
            i = np.argmax(np.where(near, self.elevations[0], -1))
            rows.append((self.times[i] - t, self.elevations[0][i] / height - 1))
        return np.array(rows).reshape(-1, 2)

    def rms(self, reference, first=0, later=0):
        """Root mean square error at gauge 0 over the largest reference elevation, from
        a first time [s] of the reference, which this run shows later [s]."""
        t, eta = reference[:, 0] + later, reference[:, 1]
        inside = (t >= first + later) & (t <= min(9.9 + later, self.times[-1]))
        error = np.interp(t[inside], self.times, self.elevations[0]) - eta[inside]
        return np.sqrt((error**2).mean()) / np.abs(eta).max()

    def differences(self, other):
        """Largest difference of the elevations from another run's, over the maximum
        of its gauge, before the wave breaks and to the end."""
        t = np.linspace(0, min(self.times[-1], other.times[-1]), 2001)
        apart = []
        for own, others in zip(self.elevations, other.elevations):
            others = np.interp(t, other.times, others)
            own = np.interp(t, self.times, own)
            apart.append(np.abs(own - others) / np.abs(others).max())
        apart = np.max(apart, axis=0)
        smooth = t <= (t[-1] if self.deep else BREAKS)
        return float(apart[smooth].max()), float(apart.max())

    def row(self):
        errors = self.crestErrors() if self.what == "depth0.5" else np.zeros((0, 2))
        row = {"run": self.folder.name, "dx": self.dx, "end": float(self.times[-1])}
        for k in range(3):
            known = k < len(errors)
            row[f"crest{k + 1}Time"] = float(errors[k, 0]) if known else np.nan
            row[f"crest{k + 1}Height"] = float(errors[k, 1]) if known else np.nan
        potential = (
            STARTED_POTENTIAL if self.started
            else DEEP_POTENTIAL if self.deep
            else POTENTIAL
        )
        later = STARTED_EARLIER if self.started else 0
        volume = self.moments["volume"]
        return {
            **row,
            "rms": float(self.rms(potential)),
            **{
                name: float(self.rms(EXPERIMENT, first, later)) if self.deep else np.nan
                for name, first in (("rmsExperiment", 0), ("rmsExperimentFrom4s", 4))
            },
            "volumeDrift": float(np.abs(volume / volume[0] - 1).max()),
            **cost(self.folder),
        }


def runs(room):
    """The runs of a room, coarse to fine."""
    found = [Run(f) for f in pathlib.Path(room).glob("*-dx*")]
    return sorted(found, key=lambda r: (r.what, -r.dx))
