"""Pictures and figures of the Taylor-Green vortices: plot.py <room>."""

import sys

from vortices import K, runs
from ulphCase import Case, drawParticles, pyplot, savePicture
from ulphStudy import figuresFolder, workPrecision, writeRows

import numpy as np

plt = pyplot()


def decay(found, file):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.6))
    numbers = sorted({run.Re for run in found})
    for run in found:
        look = {
            "color": f"C{numbers.index(run.Re)}",
            "ls": {25: ":", 50: "--"}.get(run.n, "-"),
            "alpha": 1 if run.mode == "default" else 0.4,
            "label": run.folder.name,
        }
        left.semilogy(run.times, run.kinetic / run.kinetic[0], **look)
        right.semilogy(run.error["Time"], run.relativeError(), **look)
    for Re in numbers:
        t = np.linspace(0, max(r.times[-1] for r in found if r.Re == Re))
        left.semilogy(t, np.exp(-4 * K**2 * t / Re), "k-", lw=0.8)
    left.set(xlabel="t [s]", title="kinetic energy over its start (black: exact)")
    right.set(xlabel="t [s]", title="L2 error of the velocity over its rms")
    right.legend(fontsize=7)
    savePicture(figure, file)


def speeds(run, file):
    case = Case(run.folder)
    figure, axes = plt.subplots(1, 2, figsize=(8, 3.8))
    for axis, t in zip(axes, (case.times[1], case.times[-1])):
        cloud = case.cloud(t)
        speed = np.linalg.norm(cloud["U"], axis=1)
        drawn = drawParticles(axis, cloud["x"], 1 / run.n, array=speed)
        axis.set(xlim=(0, 1), ylim=(0, 1), aspect="equal", title=f"|U|, t = {t:g} s")
        axis.set_axis_off()
        figure.colorbar(drawn, ax=axis, shrink=0.8)
    savePicture(figure, file)


def main(room):
    found = runs(room)
    figures = figuresFolder(room)
    decay(found, figures / "decay.png")
    finest = max((r for r in found if r.mode == "default"), key=lambda r: (r.n, r.Re))
    speeds(finest, figures / "speed.png")
    rows = [run.row() for run in found]
    figure, axes = plt.subplots(figsize=(5, 3.6))
    groups = {row["group"]: row["group"] for row in rows}
    workPrecision(axes, rows, "velocityError", "group", groups)
    axes.set(title="L2 error of the velocity over its rms")
    savePicture(figure, figures / "study.png")
    writeRows(figures / "figures.csv", rows)


if __name__ == "__main__":
    main(sys.argv[1])
