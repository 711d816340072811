"""Pictures of the dam break: plot.py <room> <mode>...

Written to <room>/figures; a mode that has not reached a time has no picture of it.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from check import GRAVITY, HEIGHT, LENGTH, PER_SECOND, folder, fronts
from ulphCase import Case, drawBox, drawParticles, pyplot, readTable, savePicture

plt = pyplot()

TITLES = {
    "default": "default mode",
    "paper": "paper mode",
    "lowViscosity": "default mode",
    "fine": "dx 0.005",
}
COLOURS = {"default": "C0", "paper": "C3", "lowViscosity": "C2", "fine": "C4"}

# Values of the field surface: interior, vicinity, surface, splash
CLASSES = ["#1f4fd8", "#e02020", "#12b312", "#0b5f0b"]


def atTime(case, T):
    """Fields at the dimensionless time T, None if the run ended before."""
    t = case.nearest(T / PER_SECOND)
    return case.cloud(t) if abs(t * PER_SECOND - T) < 0.06 else None


def surfacePicture(case, mode, file):
    """Figure 3 of the paper: classes on the left, normals on the right."""
    dx = case.entry("dx")
    shown = [(T, f) for T in (2.06, 5.72) if (f := atTime(case, T)) is not None]
    figure, rows = plt.subplots(
        len(shown), 2, figsize=(15, 1.75 * len(shown)), squeeze=False
    )
    for (T, fields), (left, right) in zip(shown, rows):
        x, kind, n = fields["x"], fields["surface"].astype(int), fields["normal"]
        near = kind > 0
        for axes in (left, right):
            drawBox(axes, case.bounds, top=0.3)
        drawParticles(left, x, dx, facecolors=np.array(CLASSES)[kind])
        left.set_title(f"{TITLES[mode]}, T = {T}: surface classes")

        drawParticles(right, x, dx, facecolors="0.88")
        right.quiver(
            *x[near, :2].T,
            *n[near, :2].T,
            color=np.array(CLASSES)[kind[near]],
            angles="xy",
            scale_units="xy",
            scale=1 / (1.8 * dx),
            width=0.0009,
            headwidth=4,
        )
        right.set_title(f"{TITLES[mode]}, T = {T}: outward normals")
    names = ["inside", "vicinity of the surface", "surface", "splash"]
    dots = [
        plt.Line2D([], [], ls="", marker="o", color=c, label=name)
        for c, name in zip(CLASSES, names)
    ]
    rows[0, 0].legend(handles=dots, loc="upper right", ncol=2)
    savePicture(figure, file)


def frontPicture(cases, file):
    reference = pathlib.Path(__file__).parent / "reference"
    figure, axes = plt.subplots(figsize=(6.5, 4.4))

    potential = readTable(reference / "potential_L2H_front.csv")
    axes.plot(
        potential[:, 0],
        potential[:, 1] - LENGTH / HEIGHT,
        "k-",
        label="potential flow, this column",
    )
    lobovsky = readTable(reference / "lobovsky2014_front_H300.csv")
    axes.plot(*lobovsky.T, "k:", label="Lobovsky et al. 2014, this column")
    # Their unit is the base a = H/2 and their time t sqrt(2g/a) = 2 t sqrt(g/H)
    martin = readTable(reference / "martinMoyce1952_n2eq2_a2.25in_front.csv")
    axes.plot(
        martin[:, 0] / 2,
        (martin[:, 1] - 1) / 2,
        "x",
        color="0.5",
        label="Martin & Moyce 1952, base H/2",
    )
    for mode, case in cases.items():
        alpha = case.entry("viscosity/alpha", default=0.002)
        label = TITLES[mode]
        axes.plot(
            *fronts(case),
            color=COLOURS[mode],
            ls="--" if mode == "paper" else "-",
            label=rf"{label}, $\alpha$ = {alpha:g}",
        )
    axes.axhline((1.6 - LENGTH) / HEIGHT, color="0.7", lw=0.8)
    axes.text(0.05, 3.37, "opposite wall", color="0.5", fontsize=8)
    axes.set(
        xlim=(0, 2.8),
        ylim=(0, 3.6),
        xlabel=r"$T = t\,\sqrt{g/H}$",
        ylabel="front position (x - 0.6 m)/H",
    )
    axes.legend(loc="lower right", fontsize=8)
    savePicture(figure, file)


def pressurePicture(case, mode, file):
    dx = case.entry("dx")
    unit = case.entry("rho0") * GRAVITY * HEIGHT
    wanted = (0.8, 2.06, 2.8, 4, 5.72, 8)
    shown = [(T, f) for T in wanted if (f := atTime(case, T)) is not None]
    rows = (len(shown) + 1) // 2
    figure, grid = plt.subplots(rows, 2, figsize=(11, 1.9 * rows))
    for axes in grid.flat:
        axes.set_axis_off()
    for (T, fields), axes in zip(shown, grid.flat):
        drawBox(axes, case.bounds, top=0.45)
        discs = drawParticles(axes, fields["x"], dx, array=fields["p"] / unit)
        discs.set_clim(0, 1)
        axes.set_title(f"{TITLES[mode]}, T = {T}")
    figure.colorbar(
        discs, ax=grid, shrink=0.7, extend="both", label=r"p/($\rho_0$ g H)"
    )
    savePicture(figure, file)


if __name__ == "__main__":
    room, *modes = sys.argv[1:]
    cases = {mode: Case(folder(room, mode)) for mode in modes}
    pictures = pathlib.Path(room) / "figures"

    frontPicture(cases, pictures / "front.png")
    for mode in modes:
        if mode in ("default", "paper"):
            surfacePicture(cases[mode], mode, pictures / f"surface-{mode}.png")
            pressurePicture(cases[mode], mode, pictures / f"pressure-{mode}.png")
    print(f"Pictures are in {pictures}")
