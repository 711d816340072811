"""Picture of the standing wave: plot.py <room>; see figuresFolder."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

import numpy as np
from check import runs
from ulphCase import pyplot, savePicture
from ulphStudy import figuresFolder
from wave import IMPULSE, K, OMEGA, PERIOD, Wave

plt = pyplot()


def picture(waves, file):
    figure, (left, right) = plt.subplots(
        1, 2, figsize=(11, 3.4), gridspec_kw={"width_ratios": [2, 1]}
    )
    t = np.linspace(0, waves[-1].times[-1], 500)
    envelope = np.exp(-2 * waves[-1].nu * K**2 * t)
    left.plot(t / PERIOD, envelope * np.cos(OMEGA * t), "k-", lw=1, label="exact")
    left.plot(t / PERIOD, envelope, "k:", lw=1, label="Lighthill's decay")
    for number, wave in enumerate(waves):
        name = f"H/dx = {wave.case.folder.name[1:]}"
        look = {"color": f"C{number}", "ms": 3, "label": name}
        left.plot(wave.times / PERIOD, wave.amplitude / IMPULSE, "o", **look)
        apart = wave.amplitude / IMPULSE - np.exp(
            -2 * wave.nu * K**2 * wave.times
        ) * np.cos(OMEGA * wave.times)
        right.plot(wave.times / PERIOD, apart, **look)
    left.set(xlabel="t/T", title="amplitude of the wave's velocity over its start")
    right.set(xlabel="t/T", title="difference to the exact one")
    left.set_ylim(-1.5, 1.1)
    left.legend(ncol=4, loc="lower center", fontsize=8)
    right.legend(fontsize=8)
    savePicture(figure, file)


if __name__ == "__main__":
    room = pathlib.Path(sys.argv[1])
    folder = figuresFolder(room)
    picture([Wave(case) for case in runs(room)], folder / "wave.png")
    print(f"Picture is in {folder}")
