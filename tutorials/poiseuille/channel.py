"""Runs of the flow between plates: exact profile, errors, costs."""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from ulphStudy import cost, table

FORCE, NU, HEIGHT = 0.8, 0.1, 1.0  # as in constant/flow


def exact(y, t):
    """Velocity [m/s] at the heights y, shape (n,), at time t."""
    U = FORCE / (2 * NU) * y * (HEIGHT - y)
    for k in range(1, 200, 2):
        rate = (np.pi * k / HEIGHT) ** 2 * NU
        U = U - (
            4 * FORCE * HEIGHT**2 / (NU * np.pi**3 * k**3)
            * np.sin(np.pi * k * y / HEIGHT) * np.exp(-rate * t)
        )
    return U


class Run:
    """A folder <mode>-H<particles over the height>."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        found = re.fullmatch(r"(\D+)-H(\d+)", self.folder.name)
        self.mode, self.n = found[1], int(found[2])
        error = table(folder, "error")
        self.times = error["Time"]
        steady = FORCE * HEIGHT**2 / (NU * np.sqrt(120))  # rms of the steady profile
        self.error = error["U_L2"] / steady

    def row(self):
        return {
            "run": self.folder.name,
            "mode": self.mode,
            "resolution": self.n,
            "largestError": float(self.error.max()),
            "endError": float(self.error[-1]),
            **cost(self.folder),
        }


def runs(room):
    """The runs of a room by mode and resolution."""
    found = [Run(f) for f in pathlib.Path(room).glob("*-H*")]
    return sorted(found, key=lambda r: (r.mode, r.n))
