"""Checks of the standing wave: check.py <room>, with a folder per run, R<H/dx>."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "common"))

from ulphCase import Case, Checks
from wave import IMPULSE, K, OMEGA, PERIOD, Wave, viscousRoot


def runs(room):
    """The runs of a room, coarse to fine."""
    folders = pathlib.Path(room).glob("R[0-9]*")
    return [Case(f) for f in sorted(folders, key=lambda f: int(f.name[1:]))]


def checkRun(case):
    check = Checks(case.folder.name + ".")
    wave = Wave(case)
    exactRate, exactOmega = viscousRoot(wave.nu)
    lighthill = 4 * wave.nu * K**2

    check("finished", case.finished(), 1, 1)
    check("periods", wave.times[-1] / PERIOD, 5)
    check("omega/exact", wave.omega / OMEGA, 0.95, 1.05)
    check("decayRate/Lighthill", wave.rate / lighthill, 0.95, 1.05)
    check("amplitude/exact", wave.start / IMPULSE, 0.95, 1.05)
    print(
        f"{case.folder.name}: omega {wave.omega:.4f} 1/s (inviscid {OMEGA:.4f}, "
        f"viscous {exactOmega:.4f}); decay of the energy {wave.rate:.4f} 1/s "
        f"(Lighthill {lighthill:.4f}, Lamb {exactRate:.4f}); amplitude at the start "
        f"{wave.start:.4f} m/s, misfit {wave.misfit:.4f} of it; "
        f"{case.executionTime():.1f} s of CPU time"
    )
    return check.failed


if __name__ == "__main__":
    cases = runs(sys.argv[1])
    failed = [checkRun(case) for case in cases]
    sys.exit(1 if any(failed) or not cases else 0)
