"""Figures of whole runs in mixed and in double precision, beside their bounds.

Reads what the script precision has run. A difference below a tenth of the bound
passes.
"""

import csv
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
TUTORIALS = HERE.parents[1] / "tutorials"
sys.path.insert(0, str(TUTORIALS / "common"))

from ulphStudy import cost


def droplet(folder):
    """Figure to its value and its bound."""
    from exact import Run

    figures = Run(folder).figures()
    bounds = {
        "rmsAxisError": 0.0015, "maxAxisError": 0.005,
        "areaDrift": 0.005, "energyChange": 0.06,
    }
    return {name: (figures[name], bound) for name, bound in bounds.items()}


def square(folder):
    from patch import Run

    figures = Run(folder).figures()
    bounds = {name: 0.004 for name in ("p0.6", "p1.2", "p2.04", "p4")}
    bounds.update({name: 0.5 for name in ("surface0.60", "surface1.20", "surface2.04")})
    bounds["angularMomentum4"] = 1 - 0.985
    return {name: (figures[name], bound) for name, bound in bounds.items()}


def damBreak(folder):
    import numpy as np
    from check import fronts, surface
    from ulphCase import Case

    case = Case(folder)
    times, front = fronts(case)
    # From the middle of the bounds, 2.1 and 2.35, to either
    return {
        "frontAtT2": (np.interp(2, times, front), 0.125),
        **surface(case, 2.06),
        **surface(case, 5.72),
    }


if __name__ == "__main__":
    failed = 0
    with open(HERE / "log.precision.csv", "w") as file:
        table = csv.writer(file)
        table.writerow(["case", "figure", "mixed", "double", "bound",
                        "difference/bound", "CPU s mixed", "CPU s double"])
        for case, run, figures in (("oscillatingDroplet", "R25", droplet),
                                   ("rotatingSquare", "L100", square),
                                   ("damBreak2D", "T8", damBreak)):
            sys.path.insert(0, str(TUTORIALS / case))
            folders = [TUTORIALS / case / "precision-runs" / f"{precision}-{run}"
                       for precision in ("mixed", "double")]
            mixed, double = map(figures, folders)
            seconds = [round(cost(folder)["cpuSeconds"], 1) for folder in folders]
            for name, (value, bound) in mixed.items():
                other = double[name][0]
                share = abs(value - other) / bound
                # A figure that is not finite fails
                failed += not share < 0.1
                table.writerow([case, name, f"{value:.6g}", f"{other:.6g}", bound,
                                f"{share:.2g}", *seconds])
                print(f"{'PASS' if share < 0.1 else 'FAIL'} {case:20s} {name:24s}"
                      f" mixed {value:11.5g} double {other:11.5g}"
                      f" difference/bound {share:.2g}")
            print(f"     {case:20s} CPU s mixed {seconds[0]}, double {seconds[1]}")
    sys.exit(1 if failed else 0)
