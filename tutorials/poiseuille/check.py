"""Checks of the flow between plates: check.py <room>."""

import sys

from channel import runs
from ulphCase import Checks


def main(room):
    check = Checks()
    found = [run for run in runs(room) if run.mode == "default"]
    for run in found:
        finished = "\nEnd\n" in (run.folder / "log.ulphFoam").read_text()
        check(run.folder.name + ".finished", finished, 1, 1)
        if run.n >= 40:
            check(run.folder.name + ".largestError/steadyRms", run.error.max(), None, 0.02)
            check(run.folder.name + ".endError/steadyRms", run.error[-1], None, 0.02)
    check.exit()


if __name__ == "__main__":
    main(sys.argv[1])
