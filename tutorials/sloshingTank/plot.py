"""Pictures of the sloshing tank: plot.py <room>."""

import sys

from tank import DEEP_POTENTIAL, EXPERIMENT, GAUGES, POTENTIAL, runs
from ulphCase import Case, drawBox, drawParticles, pyplot, savePicture
from ulphStudy import figuresFolder

plt = pyplot()


def elevations(found, file):
    shown = [run for run in found if run.what != "depth0.6"]
    deep = [run for run in found if run.what == "depth0.6"]
    figure, axes = plt.subplots(3 if deep else 2, 1, figsize=(9, 7.5 if deep else 5))
    for k, x in enumerate(GAUGES):
        axes[k].plot(POTENTIAL[:, 0], POTENTIAL[:, k + 1], "k-", lw=1, label="potential")
        for run in shown:
            axes[k].plot(run.times, run.elevations[k], lw=1, label=run.folder.name)
        axes[k].set(ylabel="elevation [m]", title=f"depth 0.5 m, {x:g} m from the wall")
    axes[0].legend(fontsize=7, loc="upper left")
    if deep:
        t, eta, _ = DEEP_POTENTIAL.T
        axes[2].plot(t, eta, "k-", lw=1, label="potential")
        axes[2].plot(EXPERIMENT[:, 0], EXPERIMENT[:, 1], "k.", ms=3, label="experiment")
    for run in deep:
        axes[2].plot(run.times, run.elevations[0], lw=1, label=run.folder.name)
        axes[2].set(ylabel="elevation [m]", title="depth 0.6 m, T = 1.3 s, 0.05 m")
        axes[2].legend(fontsize=7, loc="upper left")
    axes[-1].set(xlabel="t [s]")
    savePicture(figure, file)


def pressures(run, file):
    case = Case(run.folder)
    times = [t for t in (2.5, 4, 5.5, 6.5, 8, 9.5) if t <= case.times[-1]]
    figure, axes = plt.subplots(-(-len(times) // 2), 2, figsize=(9, 2.6 * (len(times) + 1) // 2))
    for axis, time in zip(axes.flat, times):
        cloud = case.cloud(case.nearest(time))
        drawn = drawParticles(axis, cloud["x"], run.dx, array=cloud["p"])
        drawn.set_clim(0, 6000)
        drawBox(axis, case.bounds)
        axis.set_title(f"p [Pa], t = {time:g} s")
        figure.colorbar(drawn, ax=axis, shrink=0.8)
    savePicture(figure, file)


def main(room):
    figures = figuresFolder(room)
    found = runs(room)
    elevations(found, figures / "elevation.png")
    shown = [run for run in found if run.what == "depth0.5" and run.dx >= 0.01]
    pressures(shown[-1], figures / "pressure.png")
    print(f"Pictures are in {figures}")


if __name__ == "__main__":
    main(sys.argv[1])
