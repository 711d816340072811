"""Checks and figures of the standing wave: check.py <room>, with a folder per
run, R<H/dx>. Writes figures/figures.csv for the room runs, <room>/figures.csv for
others.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

from ulphCase import Case, Checks
from ulphStudy import cost, figuresFolder, writeRows
from wave import IMPULSE, K, OMEGA, PERIOD, Wave, viscousRoot


def runs(room):
    """The runs of a room, coarse to fine."""
    folders = pathlib.Path(room).glob("R[0-9]*")
    return [Case(f) for f in sorted(folders, key=lambda f: int(f.name[1:]))]


def figures(wave):
    """What is checked, over the exact values, and what it costs."""
    exactRate, exactOmega = viscousRoot(wave.nu)
    return {
        "resolution": wave.case.folder.name,
        "periods": wave.times[-1] / PERIOD,
        "omega": wave.omega / OMEGA,
        "decayByLighthill": wave.rate / (4 * wave.nu * K**2),
        "decayByLamb": wave.rate / exactRate,
        "amplitude": wave.start / IMPULSE,
        "misfit": wave.misfit,
        **cost(wave.case.folder),
    }


def checkRun(wave, row):
    case = wave.case
    check = Checks(case.folder.name + ".")
    exactRate, exactOmega = viscousRoot(wave.nu)
    lighthill = 4 * wave.nu * K**2

    check("finished", case.finished(), 1, 1)
    check("periods", row["periods"], 5)
    check("omega/exact", row["omega"], 0.95, 1.05)
    check("decayRate/Lighthill", row["decayByLighthill"], 0.95, 1.05)
    check("amplitude/exact", row["amplitude"], 0.95, 1.05)
    print(
        f"{case.folder.name}: omega {wave.omega:.4f} 1/s (inviscid {OMEGA:.4f}, "
        f"viscous {exactOmega:.4f}); decay of the energy {wave.rate:.4f} 1/s "
        f"(Lighthill {lighthill:.4f}, Lamb {exactRate:.4f}); amplitude at the start "
        f"{wave.start:.4f} m/s, misfit {wave.misfit:.4f} of it; "
        f"{row['cpuSeconds']:.1f} s of CPU time"
    )
    return check.failed


if __name__ == "__main__":
    room = pathlib.Path(sys.argv[1])
    waves = [Wave(case) for case in runs(room)]
    rows = [figures(wave) for wave in waves]
    failed = [checkRun(wave, row) for wave, row in zip(waves, rows)]
    # Paper mode is reported, not held to the bounds
    for folder in room.glob("paper-R[0-9]*"):
        rows.append(figures(Wave(Case(folder))))
        row = rows[-1]
        print(
            f"{folder.name}: omega/exact {row['omega']:.4f}, decay/Lighthill "
            f"{row['decayByLighthill']:.3f}, {row['periods']:.2f} periods"
        )
    writeRows(figuresFolder(room) / "figures.csv", rows)
    sys.exit(1 if any(failed) else 0)
