"""Results of a case for the check and plot scripts of the tutorials.

Clouds are read by VTK's vtkOpenFOAMReader, which is ParaView's reader too.
Scripts reach this file by

    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))
"""

import io
import os
import pathlib
import subprocess
import sys

try:
    import numpy as np
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError as error:
    sys.exit(
        f"{error}\n    The tutorials are checked with VTK and numpy, plotted with "
        "matplotlib.\n    Mend: set ULPH_PYTHON to a python that has them "
        "(Debian: python3-vtk9 python3-numpy python3-matplotlib)"
    )


class Case:
    """A case folder: times [s], bounds of the mesh [m], entries, clouds."""

    def __init__(self, folder, cloud="fluid"):
        self.folder = pathlib.Path(folder)
        handle = self.folder / (self.folder.resolve().name + ".foam")
        handle.touch()

        self._reader = reader = vtk.vtkOpenFOAMReader()
        reader.SetFileName(str(handle))
        reader.SkipZeroTimeOff()
        reader.UpdateInformation()
        reader.DisableAllPatchArrays()
        reader.SetPatchArrayStatus("internalMesh", 1)
        reader.Update()
        self.bounds = np.array(self._part("UnstructuredGrid").GetBounds())
        self.bounds = self.bounds.reshape(3, 2)

        reader.DisableAllPatchArrays()
        reader.SetPatchArrayStatus("lagrangian/" + cloud, 1)
        reader.EnableAllLagrangianArrays()
        self.times = [float(t) for t in vtk_to_numpy(reader.GetTimeValues())]

    def _part(self, kind):
        parts = self._reader.GetOutput().NewIterator()
        while not parts.IsDoneWithTraversal():
            if parts.GetCurrentDataObject().IsA("vtk" + kind):
                return parts.GetCurrentDataObject()
            parts.GoToNextItem()
        raise RuntimeError(f"no {kind} in {self.folder}")

    def nearest(self, time):
        """The written time [s] nearest to the one asked for."""
        return min(self.times, key=lambda t: abs(t - time))

    def cloud(self, time):
        """Fields by name at a written time: "x" (n, 3) [m], those of the files.

        Scalars have the shape (n,), vectors (n, 3).
        """
        self._reader.UpdateTimeStep(time)
        points = self._part("PolyData")
        data = points.GetPointData()
        fields = {
            data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)).copy()
            for i in range(data.GetNumberOfArrays())
        }
        fields["x"] = vtk_to_numpy(points.GetPoints().GetData()).astype(float)
        return fields

    def entry(self, name, file="constant/ulphProperties", default=None):
        """Value of a dictionary entry, a float where it is one."""
        found = subprocess.run(
            ["foamDictionary", "-entry", name, "-value", self.folder / file],
            capture_output=True,
            text=True,
        )
        if found.returncode:
            if default is None:
                raise KeyError(f"no entry {name} in {self.folder / file}")
            return default
        text = found.stdout.strip()
        try:
            # OpenFOAM may warn on standard output first
            return float(text.splitlines()[-1])
        except ValueError:
            return text

    def finished(self):
        """Has the run come to its end?"""
        log = self.folder / "log.ulphFoam"
        return log.is_file() and "\nEnd\n" in log.read_text()

    def executionTime(self):
        """CPU time [s] of the run, summed over its restarts."""
        total = last = 0.0
        for line in (self.folder / "log.ulphFoam").read_text().splitlines():
            if line.startswith("ExecutionTime = "):
                now = float(line.split()[2])
                total += last if now < last else 0
                last = now
        return total + last


class Checks:
    """Lines "name value bound PASS|FAIL" and the exit status they lead to."""

    def __init__(self, prefix=""):
        self.prefix = prefix
        self.failed = 0

    def __call__(self, name, value, low=None, high=None):
        """Pass if low <= value <= high, either may be absent; nan fails."""
        good = (low is None or value >= low) and (high is None or value <= high)
        good = good and value == value
        if low == high:
            bound = f"={low:g}"
        elif low is None:
            bound = f"<={high:g}"
        elif high is None:
            bound = f">={low:g}"
        else:
            bound = f"{low:g}..{high:g}"
        verdict = "PASS" if good else "FAIL"
        print(f"{self.prefix + name:40s} {value:<12.6g} {bound:14s} {verdict}")
        self.failed += not good

    def exit(self):
        """Leave the script, with status 1 if a check has failed."""
        sys.exit(1 if self.failed else 0)


def readTable(file):
    """Numbers of a comma separated file with # comments and one line of names.

    Returns the array (rows, columns).
    """
    lines = pathlib.Path(file).read_text().splitlines()
    lines = [line for line in lines if line and line[0] != "#"]
    return np.array([[float(v) for v in line.split(",")] for line in lines[1:]])


def pyplot():
    """matplotlib.pyplot without a display, in the style of the tutorials."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams.update(
        {
            "figure.dpi": 100,
            "savefig.dpi": 110,
            "figure.constrained_layout.use": True,
            "font.size": 9,
            "axes.titlesize": 9,
            "axes.grid": False,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "legend.frameon": False,
            "lines.linewidth": 1.4,
            "image.cmap": "viridis",
        }
    )
    import matplotlib.pyplot as plt

    return plt


def drawParticles(axes, x, dx, **look):
    """Particles as discs of diameter dx; look: facecolors, or array and cmap."""
    from matplotlib.collections import EllipseCollection

    n = len(x)
    discs = EllipseCollection(
        np.full(n, dx),
        np.full(n, dx),
        np.zeros(n),
        units="xy",
        offsets=x[:, :2],
        offset_transform=axes.transData,
        linewidths=0,
        **look,
    )
    return axes.add_collection(discs)


def drawBox(axes, bounds, top=None):
    """Outline of the mesh's box in the x-y plane, cut off at the height top."""
    (x0, x1), (y0, y1) = bounds[0], bounds[1]
    high = y1 if top is None else min(top, y1)
    axes.plot([x0, x0, x1, x1], [high, y0, y0, high], color="0.3", lw=1)
    pad = 0.01 * (x1 - x0)
    axes.set(xlim=(x0 - pad, x1 + pad), ylim=(y0 - pad, high), aspect="equal")
    axes.set_axis_off()


def savePicture(figure, file):
    """Write a PNG of 256 colours, the same from run to run."""
    from PIL import Image

    os.makedirs(os.path.dirname(file), exist_ok=True)
    pixels = io.BytesIO()
    figure.savefig(pixels, format="png")
    # Maximum coverage keeps colours of few pixels
    image = Image.open(pixels).convert("RGB").quantize(256, method=1, dither=0)
    image.save(file, optimize=True)
