"""Pictures of the still tanks: plot.py <room>; see figuresFolder."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from check import BOUNDS, OTHERS, TANKS, Tank
from rest import CENTRE, LEVEL, RADIUS, outline
from ulphCase import drawParticles, pyplot, savePicture
from ulphStudy import figuresFolder

plt = pyplot()


def histories(tanks, file):
    figure, columns = plt.subplots(1, 3, figsize=(12, 3.4))
    for number, tank in enumerate(tanks):
        look = {"color": f"C{number}", "label": tank.name}
        columns[0].semilogy(tank.times[1:], tank.energy[1:], **look)
        columns[1].semilogy(tank.times[1:], tank.pressure[1:], **look)
        columns[2].plot(tank.times, tank.drift * 1e3, **look)
    for axes, upright, other, title in zip(
        columns,
        BOUNDS["upright"],
        OTHERS,
        ("kinetic over potential energy", "rms pressure error/($\\rho_0$ g H)", None),
    ):
        axes.set(xlabel="t [s]", title=title)
        if title:
            axes.axhline(upright, color="C0", ls=":", lw=1)
            axes.axhline(other, color="0.5", ls=":", lw=1)
    columns[2].set(title="centroid drift/H, in thousandths", ylim=(-2.2, 2.2))
    columns[2].legend()
    savePicture(figure, file)


def pressures(tanks, file):
    figure, grid = plt.subplots(1, 4, figsize=(13, 3))
    for tank, axes in zip(tanks, grid):
        fields = tank.case.cloud(tank.times[-1])
        discs = drawParticles(
            axes, fields["x"], tank.case.entry("dx"), array=fields["p"] / tank.unit
        )
        discs.set_clim(0, 1)
        axes.plot(*np.vstack([outline(tank.name), outline(tank.name)[:1]]).T, "0.3", lw=1)
        if tank.name == "cylinder":
            axes.add_patch(plt.Circle(CENTRE, RADIUS, fill=False, color="0.3"))
        axes.axhline(LEVEL, color="0.6", lw=0.8, ls="--")
        axes.set(title=f"{tank.name}, t = {tank.times[-1]:g} s", aspect="equal")
        axes.set_axis_off()
    figure.colorbar(discs, ax=grid, shrink=0.8, label=r"p/($\rho_0$ g H)")
    savePicture(figure, file)


if __name__ == "__main__":
    room = pathlib.Path(sys.argv[1])
    tanks = [Tank(room / name) for name in TANKS]
    folder = figuresFolder(room)
    histories(tanks, folder / "histories.png")
    pressures(tanks, folder / "pressure.png")
    print(f"Pictures are in {folder}")
