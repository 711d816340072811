"""Pictures of the oscillating drop: plot.py <room>

Written to figures for the room runs, to <room>/figures for others. What has not
run is left out.
"""

import pathlib
import sys

import numpy as np
from check import runs
from exact import KINETIC0, PERIOD, PSI, R, RHO, Exact
from ulphCase import Case, drawParticles, pyplot, savePicture
from ulphStudy import readRows, workPrecision

plt = pyplot()

# Values of the field surface: interior, vicinity, surface, splash
CLASSES = ["#1f4fd8", "#e02020", "#12b312", "#0b5f0b"]


def square(axes, size, title):
    axes.set(xlim=(-size, size), ylim=(-size, size), aspect="equal", title=title)
    axes.set_axis_off()


def startPicture(run, file):
    """Figure 5: initial pressure, surface classes, normals."""
    fields = Case(run.folder).cloud(0)
    x, kind, n = fields["x"], fields["surface"].astype(int), fields["normal"]
    near = kind > 0
    figure, (one, two, three) = plt.subplots(1, 3, figsize=(11, 3.7))
    discs = drawParticles(one, x, run.dx, array=fields["p"])
    figure.colorbar(discs, ax=one, shrink=0.8, label="p [Pa]")
    drawParticles(two, x, run.dx, facecolors=np.array(CLASSES)[kind])
    drawParticles(three, x, run.dx, facecolors="0.88")
    three.quiver(
        *x[near, :2].T,
        *n[near, :2].T,
        color=np.array(CLASSES)[kind[near]],
        angles="xy",
        scale_units="xy",
        scale=1 / (2.5 * run.dx),
        width=0.0015,
    )
    for axes, title in zip((one, two, three), ("pressure", "classes", "normals")):
        square(axes, 1.16 * R, f"{run.folder.name}, t = 0: {title}")
    savePicture(figure, file)


def pressurePicture(run, file):
    """Figure 6: pressure over the second period, with the exact outline."""
    case, exact = Case(run.folder), Exact(2 * PERIOD)
    times = [t for t in case.times if PERIOD * 0.99 < t < PERIOD * 2.01]
    figure, grid = plt.subplots(2, len(times), figsize=(2.1 * len(times), 4.1))
    angle = np.linspace(0, 2 * np.pi, 200)
    for k, (column, t) in enumerate(zip(grid.T, times)):
        fields = case.cloud(t)
        x, p = fields["x"], fields["p"]
        error = p - exact.pressure(x[:, 0], x[:, 1], t)
        a, b, _ = exact(t)
        for axes, values, limits, colours in zip(
            column, (p, error), ((0, 200), (-10, 10)), ("viridis", "coolwarm")
        ):
            discs = drawParticles(axes, x, run.dx, array=values, cmap=colours)
            discs.set_clim(*limits)
            axes.plot(a * np.cos(angle), b * np.sin(angle), "k-", lw=0.6)
            square(axes, 0.66, f"t = {t / PERIOD:.3f} T")
            if k == len(times) - 1:
                label = "p [Pa]" if limits[0] == 0 else "error of p [Pa]"
                figure.colorbar(discs, ax=axes, extend="both", label=label)
    savePicture(figure, file)


def axesPicture(all, file):
    """Figures 7 and 8: axes and their errors."""
    figure, (top, low) = plt.subplots(2, 1, figsize=(8, 6), sharex=True)
    exact = Exact(3 * PERIOD)
    t = np.linspace(0, 3 * PERIOD, 1000)
    for values, style in zip(exact(t)[:2], ("k-", "k--")):
        top.plot(t / PERIOD, values, style, lw=2, alpha=0.35)
    for k, run in enumerate(all):
        show = run.time <= 3 * PERIOD
        style = dict(color=f"C{k}", lw=0.9)
        time = run.time[show] / PERIOD
        top.plot(time, run.axes[show, 0], "-", label=run.folder.name, **style)
        top.plot(time, run.axes[show, 1], "--", **style)
        low.plot(time, run.error[show, 1], label=run.folder.name, **style)
    top.set(ylabel="semi-axes [m]; grey: exact", title="a (full), b (dashed)")
    low.legend(fontsize=7, loc="lower left")
    low.set(xlabel="t/T", ylabel="error of b over R")
    low.axhline(0, color="0.7", lw=0.6)
    savePicture(figure, file)


def energyPicture(all, file):
    """Energy, and its change over the kinetic energy at the start."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 3.8))
    if not all:
        return
    first = all[0]
    t = first.energy["Time"] / PERIOD
    a, b, omega = first.exact(first.energy["Time"])
    mass = RHO * np.pi * R * R
    left.plot(t, mass / 8 * omega**2 * (a**2 + b**2), "k", lw=3, alpha=0.3)
    left.plot(
        t,
        mass / 8 * PSI**2 * (a**2 + b**2) - mass / 4 * PSI**2 * R**2,
        "k--",
        lw=3,
        alpha=0.3,
    )
    e = first.energy
    rest = e["potential"][0]
    left.plot(t, e["kinetic"], "C0", label="kinetic")
    left.plot(t, e["potential"] - rest, "C1--", label="potential, less the first")
    left.plot(t, e["total"] - e["total"][0], "C2", label="total, less the first")
    left.set(xlabel="t/T", ylabel="J/m", title=f"{first.folder.name}; grey: exact")
    left.legend(fontsize=8)
    for k, run in enumerate(all):
        e = run.energy
        t = e["Time"] / PERIOD
        change = (e["total"] - e["total"][0]) / KINETIC0
        right.plot(t, change, color=f"C{k}", lw=1, label=run.folder.name)
        for effect, style in (("shifting", "--"), ("densityDiffusion", ":")):
            right.plot(t, e[effect] / KINETIC0, style, color=f"C{k}", lw=1)
    right.set(
        xlabel="t/T",
        ylim=(-0.15, 0.02),
        ylabel="change of total energy over Ek(0)",
        title="dashed: by shifting, dotted: by density diffusion",
    )
    right.legend(fontsize=7)
    savePicture(figure, file)


def studyPicture(table, file):
    """Error over spacing and over CPU time, from the rows of check.py."""
    studied = (
        *("default", "rings", "packed", "sharp", "noShift", "fastSound"),
        *("midpoint", "paper", "paperLeapfrog", "paperViscous"),
    )
    rows = [
        {**row, "cpuSeconds": row["cpuSeconds"] / row["periods"]}
        for row in readRows(table)
        if row["mode"] in studied and np.isfinite(row["rmsFirstPeriod"])
    ]
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.4), sharey=True)
    for k, mode in enumerate(dict.fromkeys(row["mode"] for row in rows)):
        chosen = [row for row in rows if row["mode"] == mode]
        n = np.array([int(row["resolution"][1:]) for row in chosen])
        error = [row["rmsFirstPeriod"] for row in chosen]
        left.loglog(1 / n, error, "o-", ms=4, color=f"C{k}", label=mode)
    n = np.array([12, 200])
    for power, style in ((1, ":"), (2, "--")):
        slope = 4e-4 * (12.0 / n) ** power
        left.loglog(1 / n, slope, "k" + style, lw=0.8, label=f"order {power}")
    left.set(xlabel="dx/R", ylabel="rms error of the axes over R, first period")
    left.grid(which="both", color="0.92", lw=0.6)
    left.legend(fontsize=7)
    workPrecision(right, rows, "rmsFirstPeriod")
    right.set(xlabel="CPU time per period [s]")
    savePicture(figure, file)


if __name__ == "__main__":
    room = pathlib.Path(sys.argv[1])
    pictures = pathlib.Path("figures") if room.name == "runs" else room / "figures"
    figures = pictures if room.name == "runs" else room
    all = runs(room)
    byName = {run.folder.name: run for run in all}

    def chosen(*names):
        return [byName[name] for name in names if name in byName]

    starts = chosen("default-R50", "rings-R50", "packed-R50")
    for run in starts or chosen("default-R25"):
        startPicture(run, pictures / f"start-{run.mode}.png")
    for run in chosen("default-R50", "default-R25")[:1]:
        pressurePicture(run, pictures / "pressure.png")
    shown = chosen("default-R25", "default-R50", "paper-R25", "paper-R50")
    axesPicture(shown, pictures / "axes.png")
    energyPicture(shown, pictures / "energy.png")
    studyPicture(figures / "figures.csv", pictures / "study.png")
    print(f"Pictures are in {pictures}")
