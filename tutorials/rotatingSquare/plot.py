"""Pictures of the rotating square: plot.py <room>

Written to figures for the room runs, to <room>/figures for others. What has not
run is left out.
"""

import pathlib
import sys

import numpy as np
from patch import OMEGA, PRESSURE, SURFACES, outline, referencePressure, runs, tipRadius
from ulphCase import drawParticles, pyplot, savePicture
from ulphStudy import readRows, workPrecision

plt = pyplot()


def frames(run, wanted):
    """(t omega, fields) of the written times nearest to those wanted."""
    found = []
    for tOmega in wanted:
        time = run.case.nearest(tOmega / OMEGA)
        if abs(time * OMEGA - tOmega) < 0.07:
            found.append((time * OMEGA, run.case.cloud(time)))
    return found


def square(axes, tOmega, title):
    size = 1.05 * tipRadius(tOmega)
    axes.set(xlim=(-size, size), ylim=(-size, size), aspect="equal", title=title)
    axes.set_axis_off()


def surfacePicture(run, file):
    """Figures 11 and 12: pressure and speed with the reference outline."""
    shown = frames(run, [float(t) for t in SURFACES])
    figure, grid = plt.subplots(2, len(shown), figsize=(3.6 * len(shown), 6.6))
    for column, (tOmega, fields), name in zip(grid.T, shown, SURFACES):
        last = name == SURFACES[len(shown) - 1]
        line = outline(name)
        speed = np.linalg.norm(fields["U"], axis=1) / OMEGA
        for axes, values, limits, label in zip(
            column,
            (fields["p"] / PRESSURE, speed),
            ((-0.13, 0.02), (0, 0.75)),
            (r"p/($\rho\omega^2L^2$)", r"|U|/($\omega L$)"),
        ):
            discs = drawParticles(axes, fields["x"], run.dx, array=values)
            discs.set_clim(*limits)
            axes.plot(*line.T, "k-", lw=0.7)
            square(axes, tOmega, rf"{run.folder.name}, t$\omega$ = {tOmega:.2f}")
            if last:
                figure.colorbar(discs, ax=axes, extend="both", label=label)
    savePicture(figure, file)


def latePicture(run, wanted, file):
    """Figure 13: pressure later on, or where a run stopped."""
    shown = frames(run, wanted)
    if not shown:
        return
    figure, row = plt.subplots(
        1, len(shown), figsize=(3.7 * len(shown), 3.6), squeeze=False
    )
    for axes, (tOmega, fields) in zip(row[0], shown):
        discs = drawParticles(
            axes, fields["x"], run.dx, array=fields["p"] / PRESSURE
        )
        discs.set_clim(-0.04, 0.04)
        square(axes, tOmega, rf"{run.folder.name}, t$\omega$ = {tOmega:.2f}")
    figure.colorbar(discs, ax=row[0], extend="both", label=r"p/($\rho\omega^2L^2$)")
    savePicture(figure, file)


def centrePicture(all, file):
    """Figure 14: pressure at the centre, and angular momentum and energy."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4))
    for k, run in enumerate(all):
        t = run.centre["Time"] * OMEGA
        label = run.folder.name
        left.plot(t, run.centre["p_0"] / PRESSURE, f"C{k}", lw=0.9, label=label)
        t = run.moments["Time"] * OMEGA
        angular = run.moments["angularMomentum_z"]
        kinetic = run.energy["kinetic"]
        right.plot(t, angular / angular[0], f"C{k}", lw=0.9, label=label)
        right.plot(
            run.energy["Time"] * OMEGA, kinetic / kinetic[0], f"C{k}--", lw=0.9
        )
    left.plot(*referencePressure(), "k:", lw=1.5, label="boundary integrals")
    left.set(
        xlim=(0, 8),
        ylim=(-0.16, 0.04),
        xlabel=r"t $\omega$",
        ylabel=r"p(centre)/($\rho\omega^2L^2$)",
    )
    left.legend(fontsize=7)
    right.set(
        xlim=(0, 8),
        ylim=(0.9, 1.01),
        xlabel=r"t $\omega$",
        title="angular momentum (full), kinetic energy (dashed) over the first",
    )
    savePicture(figure, file)


def studyPicture(table, file):
    """Work-precision: errors over CPU time of the whole run, from check.py's rows."""
    rows = readRows(table)
    for row in rows:
        row["lost"] = abs(1 - row["angularMomentum4"])
        row["surface"] = np.mean([row["surface" + t] for t in SURFACES])
        row["surface"] /= float(row["resolution"][1:])
    figure, grid = plt.subplots(1, 3, figsize=(13, 4))
    for axes, (error, label) in zip(
        grid,
        {
            "pressureError": r"rms error of centre pressure, $t\omega$ < 4",
            "surface": "mean distance of the outline over L",
            "lost": r"angular momentum lost at $t\omega$ = 4",
        }.items(),
    ):
        workPrecision(axes, rows, error)
        axes.set(title=label)
    savePicture(figure, file)


if __name__ == "__main__":
    room = pathlib.Path(sys.argv[1])
    pictures = pathlib.Path("figures") if room.name == "runs" else room / "figures"
    figures = pictures if room.name == "runs" else room
    all = runs(room)
    fine = {run.mode: run for run in all if run.dx > 0.007}
    for mode in ("default", "paper"):
        if mode in fine:
            run = fine[mode]
            surfacePicture(run, pictures / f"surface-{mode}.png")
            late = (4, 6, 8) if run.end > 8 else (4, 6, run.end)
            latePicture(run, late, pictures / f"late-{mode}.png")
    shown = [run for run in all if run.mode in ("default", "paper")]
    centrePicture(shown, pictures / "centre.png")
    studyPicture(figures / "figures.csv", pictures / "study.png")
    print(f"Pictures are in {pictures}")
