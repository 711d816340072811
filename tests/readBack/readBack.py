#!/usr/bin/env python3
# ulphFoam: free-surface flow with updated Lagrangian particles
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading of what ulphFoam wrote, by an own parser and by VTK.

    readBack.py finite <case> <time>            no value is NaN or infinite
    readBack.py below <case> <time> <field> <bound>     no larger magnitude
    readBack.py openfoam <case> <time>          as vtkOpenFOAMReader sees it
    readBack.py vtp <case> <time> <file>        as in a .vtp of others
    readBack.py near <case> <other> <time>      two cases, to 1e-6

Exit status 0 if number of particles, positions and all fields agree.
"""

import pathlib
import re
import sys

import numpy as np

COMPONENTS = {"vectorField": 3, "scalarField": 1, "labelField": 1}


def header(data):
    entries = re.search(rb"FoamFile\s*\{(.*?)\}", data, re.S).group(1).decode()
    return dict(re.findall(r"(\w+)\s+\"?([^;\"]+)\"?;", entries))


def body(data):
    """Number of entries, opening bracket, and where the entries start."""
    start = data.index(b"}") + 1
    match = re.compile(rb"(?:\s|//[^\n]*\n)*(\d+)\s*([({])").match(data, start)
    return int(match.group(1)), match.group(2), match.end()


def readField(path):
    data = path.read_bytes()
    head = header(data)
    number, bracket, start = body(data)
    width = COMPONENTS[head["class"]]
    kind = "<i4" if head["class"] == "labelField" else "<f8"
    if head["format"] == "binary":
        values = np.frombuffer(data, kind, number*width, start)
        assert data[start + values.nbytes:][:1] == b")", path
    else:
        # All alike are written as number{value}
        end = data.rindex(b")" if bracket == b"(" else b"}")
        values = np.array(re.sub(rb"[()]", b" ", data[start:end]).split(), kind)
        if bracket == b"{":
            values = np.tile(values, number)
    assert values.size == number*width, path
    return values.reshape(number, width) if width > 1 else values


def readPositions(path, width=3):
    """Positions and cells; with width 4 the barycentric coordinates."""
    data = path.read_bytes()
    number, _, start = body(data)
    if header(data)["format"] == "binary":
        labels = 1 if width == 3 else 3
        size = 8*width + 4*labels
        lines = np.frombuffer(data, np.uint8, number*(size + 3), start + 1)
        lines = lines.reshape(number, size + 3)
        assert (lines[:, 0] == ord("(")).all(), path
        assert (lines[:, -2] == ord(")")).all(), path
        return lines[:, 1:1 + 8*width].copy().view("<f8")
    lines = data[start:data.rindex(b")")].split(b"\n")
    rows = [re.sub(rb"[()]", b" ", line).split() for line in lines if line.strip()]
    assert len(rows) == number, path
    return np.array([row[:width] for row in rows], float)


def readCloud(case, time):
    """Positions and all fields by name."""
    folder = pathlib.Path(case, time, "lagrangian", "fluid")
    fields = {
        path.name: readField(path) for path in folder.iterdir()
        if path.name not in ("positions", "coordinates")
    }
    positions = readPositions(folder/"positions")
    assert len(readPositions(folder/"coordinates", 4)) == len(positions)
    for name, values in fields.items():
        assert len(values) == len(positions), name
    return positions, fields


def readPolyData(data):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    points = data.GetPointData()
    fields = {
        points.GetArrayName(i): vtk_to_numpy(points.GetArray(i))
        for i in range(points.GetNumberOfArrays())
    }
    return vtk_to_numpy(data.GetPoints().GetData()), fields


def readOpenFOAM(case, time):
    """The cloud as ParaView's reader sees it."""
    from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
    file = pathlib.Path(case, "case.foam")
    file.touch()
    reader = vtkOpenFOAMReader()
    reader.SetFileName(str(file))
    reader.SkipZeroTimeOff()
    reader.UpdateInformation()
    reader.EnableAllLagrangianArrays()
    reader.EnableAllPatchArrays()
    times = reader.GetTimeValues()
    listed = [times.GetValue(i) for i in range(times.GetNumberOfTuples())]
    reader.UpdateTimeStep(min(listed, key=lambda t: abs(t - float(time))))
    reader.Update()

    leaves = reader.GetOutput().NewIterator()
    leaves.InitTraversal()
    while not leaves.IsDoneWithTraversal():
        data = leaves.GetCurrentDataObject()
        if data.IsA("vtkPolyData") and data.GetPointData().HasArray("origId"):
            return readPolyData(data)
        leaves.GoToNextItem()
    sys.exit("the reader finds no cloud")


def readVtp(file):
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(file)
    reader.Update()
    return readPolyData(reader.GetOutput())


def compare(written, seen, tolerance, wanted):
    """Print what differs; both are (positions, fields)."""
    differ = []
    if len(written[0]) != len(seen[0]):
        differ.append(f"{len(seen[0])} particles of {len(written[0])}")
        return differ
    if missing := [name for name in wanted if name not in seen[1]]:
        differ.append(f"no {missing}")
    for name, values in [("positions", seen[0]), *seen[1].items()]:
        mine = written[0] if name == "positions" else written[1].get(name)
        if mine is None:
            differ.append(f"{name} was not written")
            continue
        scale = max(abs(mine).max(), 1e-300)
        error = abs(values.reshape(mine.shape).astype(float) - mine).max()/scale
        if not error <= tolerance:
            differ.append(f"{name} differs by {error:.2e}")
    return differ


def main(what, case, *rest):
    if what == "near":
        a, b = (readCloud(c, rest[1]) for c in (case, rest[0]))
        order = [np.argsort(c[1]["origId"]) for c in (a, b)]
        a, b = ((c[0][i], {"U": c[1]["U"][i]}) for c, i in zip((a, b), order))
        return compare(a, b, 1e-6, ["U"])

    written = readCloud(case, rest[0])
    if what == "finite":
        fields = {"positions": written[0], **written[1]}
        return [n for n, values in fields.items() if not np.isfinite(values).all()]

    if what == "below":
        values = np.atleast_2d(written[1][rest[1]].T)
        largest = np.sqrt((values**2).sum(axis=0)).max()
        return [] if largest <= float(rest[2]) else [f"{rest[1]} up to {largest}"]

    # VTK keeps single precision
    every = ["U", "p", "rho", "lambda", "surface", "normal"]
    if what == "openfoam":
        return compare(written, readOpenFOAM(case, rest[0]), 1e-6, written[1])
    return compare(written, readVtp(rest[1]), 1e-6, every)


if __name__ == "__main__":
    problems = main(*sys.argv[1:])
    for problem in problems:
        print("     ", problem)
    sys.exit(1 if problems else 0)
