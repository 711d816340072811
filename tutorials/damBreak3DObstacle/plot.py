"""Pictures of the dam break against a box: plot.py <room>."""

import sys

import numpy as np
from obstacle import EXPERIMENT, GAUGES, IMPACT, UNIT, Run
from ulphCase import drawParticles, pyplot, savePicture
from ulphStudy import bySpacing, figuresFolder

plt = pyplot()


def curves(found, file):
    figure, grid = plt.subplots(4, 2, figsize=(10, 12))
    for k, axes in enumerate(grid.flat[:4]):
        axes.plot(EXPERIMENT[:, 0], EXPERIMENT[:, 1 + k], "ko", ms=3,
                  label="experiment")
        for run in found:
            axes.plot(run.gaugeTimes, run.heights[k], lw=0.8, label=run.folder.name)
        axes.set(xlim=(0, found[-1].gaugeTimes[-1]), ylim=(0, 0.6),
                 title=f"height of water at x = {GAUGES[k]} m [m]")
    grid[0, 0].legend(fontsize=8)
    axes = grid[2, 0]
    axes.plot(EXPERIMENT[:, 0], EXPERIMENT[:, 5] / 1000, "ko", ms=3)
    axes.plot([IMPACT[0, 1]] * 2, [0, IMPACT[0, 2] / 1000], "k:", lw=0.8)
    for run in found:
        axes.plot(run.times, run.pressures[0] / 1000, lw=0.6)
    axes.set(xlim=(0, found[-1].times[-1]), ylim=(-1, 15), xlabel="t [s]",
             title="pressure of sensor 1 [kPa]; dotted: arrival and peak")
    for run in found:
        grid[2, 1].plot(run.forceTimes, run.force, lw=0.6)
    grid[2, 1].set(xlim=(0, found[-1].times[-1]), xlabel="t [s]",
                   title="force on the box along the flow [N]")
    for axes, k in zip(grid[3], (4, 7)):
        for run in found:
            axes.plot(run.times, run.pressures[k] / 1000, lw=0.6)
        axes.set(xlim=(0, found[-1].times[-1]), xlabel="t [s]",
                 title=f"pressure of sensor {k + 1}, on top of the box [kPa]")
    savePicture(figure, file)


def views(run, file):
    """Views from the side and from above; nearer particles hide those behind."""
    times = [t for t in (0.4, 0.6, 1.0, 1.5, 2.0, 2.5) if t <= run.case.times[-1]]
    figure, grid = plt.subplots(len(times), 2, figsize=(10, 2.2 * len(times)))
    for row, time in zip(np.atleast_2d(grid), times):
        cloud = run.case.cloud(run.case.nearest(time))
        for axes, (across, depth, sign) in zip(row, ((2, 1, -1), (1, 2, 1))):
            axes.set_axis_off()
            order = np.argsort(sign * cloud["x"][:, depth])
            places = cloud["x"][order][:, [0, across]]
            drawParticles(
                axes, places, run.dx, array=cloud["p"][order] / UNIT
            ).set_clim(0, 1)
            low, high = run.case.bounds[[0, across]].T
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
            axes.set_title(f"p/(rho g H), t = {time} s", fontsize=9)
    savePicture(figure, file)


def main(room):
    figures = figuresFolder(room)
    found = bySpacing(room, Run)
    curves(found, figures / "curves.png")
    views(found[-1], figures / "views.png")
    print(f"Pictures are in {figures}")


if __name__ == "__main__":
    main(sys.argv[1])
