# ulphFoam: free-surface flow with updated Lagrangian particles
# SPDX-License-Identifier: GPL-3.0-or-later

"""Are the particles of two cases the same but for rounding?

Usage: compare.py <case> <other> <bound>

At all times but the start, particles of the same number may differ by the bound,
over the largest value of each field. Exit status 1 where they differ by more, or
where one case lacks a time or a particle.
"""

import pathlib
import sys

sys.path.insert(
    0, str(pathlib.Path(__file__).resolve().parents[2] / "tutorials/common")
)

import numpy as np
from ulphCase import Case

FIELDS = ("x", "U", "p", "mass", "lambda", "surface")


def byNumber(case, time):
    """Fields of the cloud, in the order of the numbers given at the start."""
    cloud = case.cloud(time)
    order = np.argsort(cloud["origId"])
    return {name: values[order] for name, values in cloud.items()}


def main(first, second, bound):
    one, other = Case(first), Case(second)
    # reconstructPar leaves out the start
    times = [time for time in one.times if time > 0]
    if not times or times != [time for time in other.times if time > 0]:
        sys.exit(f"times {one.times} and {other.times}")
    worst = 0.0
    for time in times:
        a, b = byNumber(one, time), byNumber(other, time)
        if not np.array_equal(a["origId"], b["origId"]):
            sys.exit(f"other particles at {time}")
        for name in FIELDS:
            if name in a:
                size = np.abs(a[name]).max()
                apart = np.abs(a[name] - b[name]).max() / (size or 1)
                if apart > bound:
                    print(f"{name} at {time}: {apart:.3g} apart")
                worst = max(worst, apart)
    print(f"largest difference {worst:.3g} of {bound:g}")
    sys.exit(not worst <= bound)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], float(sys.argv[3]))
