"""Pictures and figures of the flow between plates: plot.py <room>."""

import sys

from channel import HEIGHT, exact, runs
from ulphCase import Case, pyplot, savePicture
from ulphStudy import figuresFolder, writeRows

import numpy as np

plt = pyplot()


def profiles(run, axes):
    case = Case(run.folder)
    y = np.linspace(0, HEIGHT, 200)
    for k, time in enumerate((0.5, 1, 2, 4)):
        t = case.nearest(time)
        cloud = case.cloud(t)
        axes.plot(cloud["U"][:, 0], cloud["x"][:, 1], ".", ms=2, color=f"C{k}")
        axes.plot(exact(y, t), y, "k-", lw=0.8)
        axes.text(exact(np.array([0.5 * HEIGHT]), t)[0], 0.52, f"{t:g} s", fontsize=8)
    axes.set(xlabel="U [m/s]", ylabel="y [m]", title=f"{run.folder.name} (black: exact)")


def main(room):
    found = runs(room)
    figures = figuresFolder(room)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.8))
    profiles(max((r for r in found if r.mode == "default"), key=lambda r: r.n), left)
    for run in found:
        right.semilogy(run.times[1:], run.error[1:], label=run.folder.name)
    right.axhline(0.02, color="0.5", lw=0.8, ls="--")
    right.set(xlabel="t [s]", title="L2 error of the velocity over the steady rms")
    right.legend(fontsize=8)
    savePicture(figure, figures / "channel.png")
    writeRows(figures / "figures.csv", [run.row() for run in found])


if __name__ == "__main__":
    main(sys.argv[1])
