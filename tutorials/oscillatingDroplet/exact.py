"""Exact solution of the oscillating drop, eq. (43), and figures of a run."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from ulphStudy import cost, table, vector

R, PSI, OMEGA0, RHO = 0.5, 1.2, 0.4, 1000.0
PERIOD = 3.751297729
KINETIC0 = RHO * np.pi * R**4 * OMEGA0**2 / 4  # [J/m]


def _rate(a, omega):
    b = R * R / a
    return omega * a, (omega**2 + PSI**2) * (b * b - a * a) / (a * a + b * b)


class Exact:
    """Semi-axes a, b [m] and strain rate Omega [1/s] to 1e-10, up to a time [s]."""

    def __init__(self, end, dt=1e-3):
        steps = int(np.ceil(end / dt)) + 1
        self._dt = dt
        self._y = np.empty((steps + 1, 2))
        self._f = np.empty((steps + 1, 2))
        y = (R, OMEGA0)
        for i in range(steps + 1):
            k1 = _rate(*y)
            self._y[i], self._f[i] = y, k1
            k2 = _rate(y[0] + dt / 2 * k1[0], y[1] + dt / 2 * k1[1])
            k3 = _rate(y[0] + dt / 2 * k2[0], y[1] + dt / 2 * k2[1])
            k4 = _rate(y[0] + dt * k3[0], y[1] + dt * k3[1])
            y = tuple(
                y[c] + dt / 6 * (k1[c] + 2 * k2[c] + 2 * k3[c] + k4[c]) for c in (0, 1)
            )

    def __call__(self, time):
        """a, b, Omega at times, each of the times' shape."""
        time = np.asarray(time, dtype=float)
        i = np.clip((time / self._dt).astype(int), 0, len(self._y) - 2)
        s = (time / self._dt - i)[..., None]
        y0, y1 = self._y[i], self._y[i + 1]
        f0, f1 = self._f[i] * self._dt, self._f[i + 1] * self._dt
        y = (
            y0 * (1 + 2 * s) * (1 - s) ** 2
            + y1 * s**2 * (3 - 2 * s)
            + f0 * s * (1 - s) ** 2
            + f1 * s**2 * (s - 1)
        )
        a, omega = y[..., 0], y[..., 1]
        return a, R * R / a, omega

    def pressure(self, x, y, time):
        """Pressure [Pa] inside the drop at points and one time."""
        a, b, omega = self(time)
        scale = RHO * (omega**2 + PSI**2) * a**2 * b**2 / (a**2 + b**2)
        return scale * (1 - x**2 / a**2 - y**2 / b**2)


class Run:
    """Axes from second moments, scaled to R at the start, energies, errors."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.mode, self.resolution = self.folder.name.rsplit("-", 1)
        self.dx = R / int(self.resolution[1:])
        self.moments = table(folder, "moments")
        self.energy = table(folder, "energy")
        self.time = self.moments["Time"]
        self.end = self.time[-1]
        axes = vector(self.moments, "axis")[:, :2]
        self.axes = axes * R / axes[0]
        extents = vector(self.moments, "extent")[:, :2]
        self.extents = extents * R / extents[0]
        self.exact = Exact(self.end)
        a, b, _ = self.exact(self.time)
        self.error = (self.axes - np.stack([a, b], axis=1)) / R
        self.extentError = (self.extents - np.stack([a, b], axis=1)) / R

    def rms(self, periods):
        """Root mean square of the axis error over R in the first periods."""
        if self.end < (periods - 0.01) * PERIOD:
            return np.nan
        return np.sqrt((self.error[self.time <= periods * PERIOD] ** 2).mean())

    def amplitudeKept(self):
        """Amplitude of the last period over that of the exact solution.

        The amplitude is half the range of (a - b)/(a + b), which a change of
        area leaves alone.
        """
        last = self.time > self.end - PERIOD
        a, b = self.axes[last].T
        ea, eb, _ = self.exact(self.time[last])
        return np.ptp((a - b) / (a + b)) / np.ptp((ea - eb) / (ea + eb))

    def figures(self):
        area = self.axes.prod(axis=1) / R**2
        total = self.energy["kinetic"] + self.energy["potential"]
        momentum = np.linalg.norm(vector(self.moments, "momentum"), axis=1)
        angular = np.abs(self.moments["angularMomentum_z"])
        mass = self.moments["mass"][0]
        return {
            "mode": self.mode,
            "resolution": self.resolution,
            "periods": round(self.end / PERIOD, 2),
            "rmsAxisError": self.rms(self.end / PERIOD),
            "maxAxisError": np.abs(self.error).max(),
            "rmsFirstPeriod": self.rms(1),
            "rmsTwoPeriods": self.rms(2),
            "rmsExtentError": np.sqrt((self.extentError**2).mean()),
            "areaDrift": area[-1] - 1,
            "energyChange": (total[-1] - total[0]) / KINETIC0,
            "byDiffusion": self.energy["densityDiffusion"][-1] / KINETIC0,
            "byShifting": self.energy["shifting"][-1] / KINETIC0,
            "byViscosity": self.energy["viscosity"][-1] / KINETIC0,
            "budgetRest": self.energy["rest"][-1] / KINETIC0,
            "amplitudeKept": self.amplitudeKept(),
            "momentum": momentum.max() / (mass * OMEGA0 * R),
            "angularMomentum": angular.max() / (mass * OMEGA0 * R**2),
            **cost(self.folder),
        }


def ingredient(run):
    """Columns of a run in the table of ingredients."""
    figures = run.figures()
    return {
        "periods": figures["periods"],
        "rms axis/R": figures["rmsAxisError"],
        "area": figures["areaDrift"],
        "energy/Ek0": figures["energyChange"],
        "by diffusion": figures["byDiffusion"],
        "by shifting": figures["byShifting"],
    }
