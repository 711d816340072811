"""Runs of the Taylor-Green vortices: effective viscosity, errors, costs."""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from ulphStudy import cost, table

K = 2 * np.pi  # wave number, of the period 1 m [1/m]


class Run:
    """A folder <mode>Re<number>-L<particles per side>."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        found = re.fullmatch(r"(\D+)Re(\d+)-L(\d+)", self.folder.name)
        self.mode, self.Re, self.n = found[1], int(found[2]), int(found[3])
        self.nu = 1 / self.Re
        energy = table(folder, "energy")
        self.times, self.kinetic = energy["Time"], energy["kinetic"]
        self.error = table(folder, "error")

    @property
    def group(self):
        return f"{self.mode}, Re {self.Re}"

    @property
    def viscosity(self):
        """Effective over asked viscosity: slope of ln Ek over the whole run."""
        slope = np.polyfit(self.times, np.log(self.kinetic), 1)[0]
        return -slope / (4 * self.nu * K**2)

    def relativeError(self):
        """L2 error of the velocity over the rms of the exact one, at all times."""
        return self.error["U_L2"] / self.error["U_rms"]

    @property
    def lateError(self):
        """Its mean over the second half of the run."""
        late = self.error["Time"] >= 0.5 * self.times[-1]
        return self.relativeError()[late].mean()

    def row(self):
        late = self.error["Time"] >= 0.5 * self.times[-1]
        return {
            "run": self.folder.name,
            "mode": self.mode,
            "Re": self.Re,
            "resolution": self.n,
            "group": self.group,
            "endTime": float(self.times[-1]),
            "effectiveOverAskedViscosity": self.viscosity,
            "velocityError": self.lateError,
            "pressureError": float(
                (self.error["p_L2"][late] / self.error["p_rms"][late]).mean()
            ),
            **cost(self.folder),
        }


def runs(room):
    """The runs of a room by mode, Reynolds number and resolution."""
    found = [Run(f) for f in pathlib.Path(room).glob("*Re*-L*")]
    return sorted(found, key=lambda r: (r.mode, r.Re, r.n))
