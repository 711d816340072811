"""Table of the runs with one ingredient changed, in the folder of a case.

Rows of the runs in the folder ingredients go to figures/ingredients.csv, and
into README.md between the lines <!-- ingredients --> and <!-- end -->. The module
of the case, exact.py or patch.py, brings the class Run and the columns to show of
one, ingredient(run).
"""

import pathlib
import re
import sys
from importlib import import_module

sys.path.insert(0, str(pathlib.Path.cwd()))

from ulphStudy import cost, writeRows

FAMILIES = {
    "default": "-",
    "noDiffusion": "`densityDiffusion none`",
    "laplacian": "`densityDiffusion laplacian`",
    "relaxation": "`densityRelaxation moment`",
    "noShift": "`shifting none`",
    "XuShift": "`shifting XuStansbyLaurence`",
    "halfShift": "`shifting` with C 1, not 2",
    "noSurface": "`freeSurface none`",
    "fullMatrix": "`momentMatrix full`",
    "optimalMatrix": "`momentMatrix optimal`",
    "midpoint": "`timeIntegration predictorCorrector`, `maxCo 0.25`",
    "smallCo": "`maxCo 0.25`",
    "largeCo": "`maxCo 0.9`",
    "viscous": "`viscosity artificial`, alpha 0.02",
}


def rowsOf(case):
    """A row for each run there is; case is the module of the tutorial."""
    for name, changed in FAMILIES.items():
        for log in pathlib.Path("ingredients").glob(f"{name}-*/log.ulphFoam"):
            run = case.Run(log.parent)
            work = cost(run.folder)
            yield {
                "run": name,
                "changed": changed,
                **case.ingredient(run),
                "CPU s": work["cpuSeconds"],
                "steps": work["steps"],
            }


def shown(value):
    if isinstance(value, str):
        return value
    if value != value:
        return "-"
    return f"{value:.3g}"


def markdown(rows):
    names = list(rows[0])
    lines = ["| " + " | ".join(names) + " |", "|---" * len(names) + "|"]
    lines += ["| " + " | ".join(shown(row[n]) for n in names) + " |" for row in rows]
    return "\n".join(lines)


if __name__ == "__main__":
    module = next(n for n in ("exact", "patch") if pathlib.Path(n + ".py").is_file())
    rows = list(rowsOf(import_module(module)))
    writeRows("figures/ingredients.csv", rows)
    readme = pathlib.Path("README.md")
    text, count = re.subn(
        r"(<!-- ingredients -->\n).*?(\n<!-- end -->)",
        lambda part: part[1] + markdown(rows) + part[2],
        readme.read_text(),
        flags=re.S,
    )
    if not count:
        sys.exit("README.md has no place <!-- ingredients --> for the table")
    readme.write_text(text)
