"""Pictures of the piston wave maker: plot.py <room>."""

import sys

import numpy as np
from piston import DEPTH, GAUGES, HEIGHT, K, OMEGA, STROKE, runs
from ulphCase import drawParticles, pyplot, savePicture
from ulphStudy import figuresFolder

plt = pyplot()


def elevations(found, file):
    figure, rows = plt.subplots(2, 1, figsize=(9, 4), sharex=True)
    for axes, gauge in zip(rows, (0, 3)):
        t = np.linspace(0, 6, 600)
        # The piston goes by sin(omega t); far away its waves follow its speed
        theory = HEIGHT / 2 * np.cos(OMEGA * t - K * GAUGES[gauge])
        axes.plot(t, 1000 * theory, "k-", lw=0.8, label="linear theory, once regular")
        for run in found:
            axes.plot(run.times, 1000 * run.levels[gauge], label=run.folder.name)
        axes.set(ylabel="elevation [mm]", title=f"x = {GAUGES[gauge]:g} m")
    rows[0].legend(ncol=3, fontsize=8)
    rows[1].set(xlabel="t [s]")
    savePicture(figure, file)


def views(run, file):
    times = [3.25, 3.5, 3.75, 4.0]
    times = sorted({run.case.nearest(t) for t in times})
    figure, grid = plt.subplots(len(times), 1, figsize=(10, 1.6 * len(times)))
    for axes, time in zip(np.atleast_1d(grid), times):
        cloud = run.case.cloud(time)
        drawParticles(axes, cloud["x"], run.dx, array=cloud["U"][:, 0]).set_clim(-0.2, 0.2)
        piston = STROKE / 2 * np.sin(OMEGA * time)
        axes.plot([piston, piston], [0, 0.4], color="0.2", lw=2)
        axes.plot([piston, 3], [0, 0], color="0.3", lw=1)
        axes.axhline(DEPTH, color="0.6", lw=0.5)
        axes.set(xlim=(-0.06, 3), ylim=(-0.01, 0.4), aspect="equal")
        axes.set_axis_off()
        axes.set_title(f"horizontal velocity -0.2 to 0.2 m/s, t = {time:.2f} s")
    savePicture(figure, file)


def main(room):
    figures = figuresFolder(room)
    found = runs(room)
    elevations(found, figures / "elevation.png")
    views(found[-1], figures / "views.png")
    print(f"Pictures are in {figures}")


if __name__ == "__main__":
    main(sys.argv[1])
