"""Figures of a run of the rotating square against its reference solution."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from scipy.spatial import cKDTree
from ulphCase import Case, readTable
from ulphStudy import cost, table

L, OMEGA, RHO = 1.0, 20.0, 1000.0
PRESSURE = RHO * (OMEGA * L) ** 2
REFERENCE = pathlib.Path(__file__).resolve().parent / "reference"
SURFACES = ("0.60", "1.20", "2.04")  # t omega of the reference outlines
MOMENTS = (0.6, 1.2, 2.04, 4.0)  # t omega of the pressure figures


def tipRadius(tOmega):
    """Distance of the tips from the centre over L; they move in free flight."""
    return np.sqrt((1 + tOmega**2) / 2)


def outline(tOmega):
    """Closed polyline (n, 2) of the reference, x/L and y/L."""
    points = readTable(REFERENCE / f"surface_{tOmega}.csv")
    return np.concatenate([points, points[:1]])


def densified(line, step):
    """Points of a polyline no more than a step apart."""
    parts = []
    for p, q in zip(line[:-1], line[1:]):
        n = max(1, int(np.ceil(np.hypot(*(q - p)) / step)))
        parts.append(p + (q - p) * np.arange(n)[:, None] / n)
    return np.concatenate(parts + [line[-1:]])


def fluidEdge(x, volume, dx, size):
    """The outline of particles: where their kernel sum is one half.

    Points (n, 2). Wendland C2 kernel of radius 4 dx, on a grid of dx/4; a
    straight edge of evenly spread particles is found to within dx/100.
    """
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    step, reach = dx / 4, 4 * dx
    n = int(2 * size / step) + 1
    filling = np.zeros((n, n))
    cell = np.rint((x + size) / step).astype(int)
    inside = np.all((cell > 20) & (cell < n - 20), axis=1)
    x, volume, cell = x[inside], volume[inside], cell[inside]
    for i in range(-17, 18):
        for j in range(-17, 18):
            near = cell + (i, j)
            s = np.linalg.norm(near * step - size - x, axis=1) / reach
            s = np.minimum(s, 1)
            w = 7 / (np.pi * reach**2) * (1 - s) ** 4 * (1 + 4 * s)
            np.add.at(filling, (near[:, 0], near[:, 1]), w * volume)
    axis = np.arange(n) * step - size
    contour = pyplot.contour(axis, axis, filling.T, levels=[0.5])
    lines = contour.allsegs[0]
    pyplot.close()
    return [line for line in lines if len(line) > 8]


class Run:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.mode, self.resolution = self.folder.name.rsplit("-", 1)
        self.dx = L / int(self.resolution[1:])
        self.case = Case(folder)
        self.moments = table(folder, "moments")
        self.energy = table(folder, "energy")
        self.centre = table(folder, "centre")
        self.finished = self.case.finished()
        self.end = self.moments["Time"][-1] * OMEGA

    def at(self, columns, name, tOmega):
        """Value at a time, nan if the run ended before."""
        if tOmega > self.end + 1e-6:
            return np.nan
        return np.interp(tOmega / OMEGA, columns["Time"], columns[name])

    def pressure(self, tOmega):
        """Pressure at the centre over rho omega^2 L^2, mean over 0.02."""
        if tOmega > self.end:
            return np.nan
        t = self.centre["Time"] * OMEGA
        near = np.abs(t - tOmega) < 0.01
        return self.centre["p_0"][near].mean() / PRESSURE

    def ratio(self, what, tOmega):
        columns, name = {
            "energy": (self.energy, "kinetic"),
            "angularMomentum": (self.moments, "angularMomentum_z"),
        }[what]
        return self.at(columns, name, tOmega) / columns[name][0]

    def energyChange(self, column):
        """Change over the run of an energy, over the kinetic energy at the start."""
        change = self.energy[column][-1] - self.energy[column][0]
        return change / self.energy["kinetic"][0]

    def edge(self, tOmega):
        """Outline of the particles at a written time, None if there is none."""
        t = float(tOmega) / OMEGA
        nearest = self.case.nearest(t)
        if abs(nearest - t) > 1e-5:
            return None
        fields = self.case.cloud(nearest)
        volume = RHO * self.dx**2 / fields["rho"]
        return fluidEdge(
            fields["x"][:, :2], volume, self.dx, 1.1 * tipRadius(float(tOmega))
        )

    def surfaceDistance(self, tOmega):
        """Mean distance of the outline from the reference and back, over dx.

        Tips beyond 0.9 of their radius are left out.
        """
        edge = self.edge(tOmega)
        if not edge:
            return np.nan
        far = 0.9 * tipRadius(float(tOmega)) * L
        mine = np.concatenate(edge)
        its = densified(outline(tOmega), self.dx / 20)
        both = []
        for from_, to in ((mine, its), (its, densified_all(edge, self.dx / 20))):
            from_ = from_[np.linalg.norm(from_, axis=1) < far]
            both.append(cKDTree(to).query(from_)[0].mean())
        return np.mean(both) / self.dx

    def figures(self):
        row = {
            "mode": self.mode,
            "resolution": self.resolution,
            "reachedTOmega": self.end,
            "Ek2.04": self.ratio("energy", 2.04),
            "Ek8": self.ratio("energy", 8),
            "angularMomentum4": self.ratio("angularMomentum", 4),
        }
        for tOmega in MOMENTS:
            row[f"p{tOmega:g}"] = self.pressure(tOmega)
        row["pressureError"] = self.pressureError()
        for tOmega in SURFACES:
            row[f"surface{tOmega}"] = self.surfaceDistance(tOmega)
        return {**row, **cost(self.folder)}

    def pressureError(self):
        """rms error of the centre pressure to t omega = 4, over rho omega^2 L^2."""
        t = self.centre["Time"] * OMEGA
        show = t <= 4
        exact = np.interp(t[show], *referencePressure())
        return np.sqrt(((self.centre["p_0"][show] / PRESSURE - exact) ** 2).mean())


def densified_all(lines, step):
    return np.concatenate([densified(line, step) for line in lines])


def referencePressure():
    """t omega and p/(rho omega^2 L^2) at the centre."""
    return readTable(REFERENCE / "centrePressure.csv")[:, :2].T


def runs(room):
    """The runs of a room that ended or stopped, coarse to fine, mode by mode."""
    found = [
        Run(log.parent)
        for log in pathlib.Path(room).glob("*-L*/log.ulphFoam")
        if "\nEnd\n" in log.read_text() or "FOAM FATAL" in log.read_text()
    ]
    return sorted(found, key=lambda run: (run.mode, -run.dx))


def ingredient(run):
    """Columns of a run in the table of ingredients."""
    return {
        "to t omega": run.end,
        "rms p, t omega < 4": run.pressureError(),
        "surface/dx at 2.04": run.surfaceDistance("2.04"),
        "angular momentum(4)": run.ratio("angularMomentum", 4),
        "energy": run.energyChange("total"),
        "by diffusion": run.energyChange("densityDiffusion"),
        "by shifting": run.energyChange("shifting"),
    }
