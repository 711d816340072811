"""Pictures of the sloshing tank: plot.py <room>."""

import sys

from tank import (
    DEEP_POTENTIAL, EXPERIMENT, GAUGES, POTENTIAL, STARTED_EARLIER, STARTED_POTENTIAL, runs
)
from ulphCase import Case, drawBox, drawParticles, pyplot, savePicture
from ulphStudy import figuresFolder

plt = pyplot()


def elevations(found, file):
    shown = [run for run in found if not run.deep and not run.nudged]
    deep = [run for run in found if run.deep]
    number = 4 if deep else 2
    figure, axes = plt.subplots(number, 1, figsize=(9, 2.5 * number))
    for k, x in enumerate(GAUGES):
        axes[k].plot(POTENTIAL[:, 0], POTENTIAL[:, k + 1], "k-", lw=1, label="potential")
        for run in shown:
            axes[k].plot(run.times, run.elevations[k], lw=1, label=run.folder.name)
        axes[k].set(ylabel="elevation [m]", title=f"depth 0.5 m, {x:g} m from the wall")
    axes[0].legend(fontsize=7, loc="upper left")
    if deep:
        draw(axes[2], [run for run in deep if not run.started], DEEP_POTENTIAL, 0)
        started = [run for run in deep if run.started]
        draw(axes[3], started, STARTED_POTENTIAL, STARTED_EARLIER)
        axes[3].set(title="likewise, from a tank that starts from its middle")
    axes[-1].set(xlabel="t [s]")
    savePicture(figure, file)


def draw(axis, found, potential, later):
    """Deep water beside potential flow and, some time [s] later, the experiment."""
    t, eta, _ = potential.T
    axis.plot(t, eta, "k-", lw=1, label="potential")
    axis.plot(EXPERIMENT[:, 0] + later, EXPERIMENT[:, 1], "k.", ms=3, label="experiment")
    for run in found:
        axis.plot(run.times, run.elevations[0], lw=1, label=run.folder.name)
    axis.set(ylabel="elevation [m]", title="depth 0.6 m, T = 1.3 s, 0.05 m")
    axis.legend(fontsize=7, loc="upper left")


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
