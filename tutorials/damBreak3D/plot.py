"""Pictures of the dam break in three dimensions: plot.py <room>."""

import sys

import numpy as np
from dam import (
    FINITE_VOLUME, FRONT, POTENTIAL, PRESSURES, SENSORS, TURBULENT, delay, runs
)
from ulphCase import drawBox, drawParticles, pyplot, savePicture
from ulphStudy import figuresFolder

plt = pyplot()


def curves(found, file):
    figure, axes = plt.subplots(3, 1, figsize=(8, 8))
    late = delay()
    axes[0].plot(POTENTIAL[:, 0], POTENTIAL[:, 1] - 2, "k-", lw=1, label="potential flow")
    axes[0].plot(FRONT[:, 0] - late, FRONT[:, 1], "k.", ms=3, label="experiment, shifted")
    for run in found:
        before = run.frontTimes < 2.6
        axes[0].plot(run.frontTimes[before], run.front[before] - 2, label=run.folder.name)
    axes[0].set(xlim=(0, 2.6), ylim=(0, 3.5), ylabel="front (x - 0.6 m)/H")
    axes[0].legend(fontsize=8)
    for k in (0, 1):
        t, low, median, high = PRESSURES[k].T
        axes[k + 1].fill_between(t - late, low, high, color="0.85", lw=0)
        axes[k + 1].plot(t - late, median, "k-", lw=0.8)
        for solution, line, what in (
            (FINITE_VOLUME, "k--", "interFoam, 2D"),
            (TURBULENT, "k:", "interFoam, 2D, turbulent"),
        ):
            axes[k + 1].plot(
                solution[:, 0], solution[:, k + 1], line, lw=0.8, label=what
            )
        for run in found:
            axes[k + 1].plot(run.times, run.pressures[k], lw=0.8, label=run.folder.name)
        axes[k + 1].set(
            xlim=(2, 7), ylim=(-0.3, 4), ylabel="p/(rho g H)",
            title=f"sensor {k + 1}, z = {1000 * SENSORS[k]:g} mm (grey: 95 % of the runs)",
        )
    axes[1].legend(fontsize=8)
    axes[2].set(xlabel="t sqrt(g/H)")
    savePicture(figure, file)


def views(run, file):
    """Side views; nearer particles hide those behind them."""
    times = [t for t in (0.2, 0.4, 0.6, 0.8, 1.0, 1.2) if t <= run.case.times[-1]]
    figure, grid = plt.subplots(-(-len(times) // 2), 2, figsize=(10, 6))
    for axes in grid.flat:
        axes.set_axis_off()
    for axes, time in zip(grid.flat, times):
        cloud = run.case.cloud(run.case.nearest(time))
        order = np.argsort(-cloud["x"][:, 1])
        places, p = cloud["x"][order][:, [0, 2]], cloud["p"][order] / run.unit
        drawParticles(axes, places, run.dx, array=p).set_clim(0, 1)
        drawBox(axes, run.case.bounds[[0, 2]], top=2 * run.H)
        axes.set_title(f"p/(rho g H), t sqrt(g/H) = {time * run.perSecond:.2f}")
    savePicture(figure, file)


def main(room):
    figures = figuresFolder(room)
    found, others = runs(room)
    friction = [run for run in others if run.friction]
    curves(found[-2:] + friction[-2:], figures / "curves.png")
    views(found[-1], figures / "views.png")
    for run in others:
        if run.high:
            views(run, figures / "views-H600.png")
    print(f"Pictures are in {figures}")


if __name__ == "__main__":
    main(sys.argv[1])
