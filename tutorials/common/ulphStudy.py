"""What the studies over resolutions and modes share: tables, costs, orders.

A study is a folder with one case folder per run, named <mode>-<resolution>, for
instance paper-R50.
"""

import csv
import pathlib
import re

import numpy as np

# Modes of the runs that a work-precision plot compares, with their lines
LINES = {
    "default": "default, driftKickDrift",
    "midpoint": "default, predictorCorrector",
    "paperLeapfrog": "paper, driftKickDrift",
    "paper": "paper, predictorCorrector",
}


def table(folder, name, file="*"):
    """Columns by name of a function object's table, restarts joined.

    Each has the shape (rows,); rows that a restart repeats are dropped. Where the
    object writes several files, file is one of them, for instance force.
    """
    files = pathlib.Path(folder, "postProcessing", name).glob(f"*/{file}.dat")
    parts, columns = [], []
    for file in sorted(files, key=lambda f: float(f.parent.name)):
        # Vectors are written in brackets
        text = file.read_text().replace("(", " ").replace(")", " ")
        lines = text.splitlines()
        head = [line for line in lines if line.startswith("# Time")][-1]
        columns = head.lstrip("# ").split()
        rows = [line.split() for line in lines if line and line[0] != "#"]
        parts.append(np.array(rows, dtype=float).reshape(-1, len(columns)))
    if not parts:
        raise FileNotFoundError(f"no table of {name} in {folder}/postProcessing")
    for i in range(len(parts) - 1):
        parts[i] = parts[i][parts[i][:, 0] < parts[i + 1][0, 0]]
    return dict(zip(columns, np.concatenate(parts).T))


def vector(columns, name):
    """The x, y and z columns of a vector of a table, shape (rows, 3)."""
    return np.stack([columns[f"{name}_{c}"] for c in "xyz"], axis=1)


def cost(folder):
    """CPU seconds, steps, particle-steps per run, from the ledgers of its log.

    A run that stopped by itself has no ledger: its steps are counted, and the
    particles are those of its last step.
    """
    text = pathlib.Path(folder, "log.ulphFoam").read_text()
    total = last = 0.0
    for found in re.finditer(r"^ExecutionTime = (\S+) s", text, re.M):
        now = float(found.group(1))
        total += last if now < last else 0
        last = now
    seconds = total + last
    steps = len(re.findall(r"^Time = ", text, re.M))
    particles = int(re.findall(r"^particles (\d+)", text, re.M)[-1])
    return {
        "particles": particles,
        "steps": steps,
        "cpuSeconds": seconds,
        "secondsPerParticleStep": seconds / (steps * particles),
    }


def bySpacing(room, Run):
    """The runs of a room, folders dx<spacing>, coarse to fine."""
    found = [Run(folder) for folder in pathlib.Path(room).glob("dx*")]
    return sorted(found, key=lambda run: -run.dx)


def figuresFolder(room):
    """Where the figures of a room go: those of runs are kept, in figures."""
    folder = pathlib.Path("figures") if pathlib.Path(room).name == "runs" else room
    pathlib.Path(folder).mkdir(exist_ok=True)
    return pathlib.Path(folder)


def writeRows(file, rows):
    """Dictionaries to a CSV file; the first gives names and order of columns."""
    with open(file, "w", newline="") as stream:
        writer = csv.DictWriter(stream, rows[0], restval="", extrasaction="ignore")
        writer.writeheader()
        for row in rows:
            writer.writerow(
                {k: f"{v:.6g}" if isinstance(v, float) else v for k, v in row.items()}
            )
    print(f"Figures are in {file}")


def readRows(file):
    """The rows of writeRows, numbers as floats; what is empty is nan."""

    def value(text):
        try:
            return float(text)
        except ValueError:
            return text or np.nan

    with open(file, newline="") as stream:
        return [{k: value(v) for k, v in r.items()} for r in csv.DictReader(stream)]


def order(spacings, errors):
    """Slope of log(error) over log(spacing), least squares."""
    return np.polyfit(np.log(spacings), np.log(errors), 1)[0]


def workPrecision(axes, rows, error, key="mode", lines=LINES):
    """Error against CPU seconds, log-log: a line with its name per value of a key."""
    for k, (value, name) in enumerate(lines.items()):
        chosen = sorted(
            (row["cpuSeconds"], row[error], row["resolution"])
            for row in rows
            if row[key] == value and np.isfinite(row[error])
        )
        if not chosen:
            continue
        seconds, errors, _ = zip(*chosen)
        axes.loglog(seconds, errors, "o-", ms=4, color=f"C{k}", label=name)
        for s, e, r in chosen:
            axes.annotate(
                r, (s, e), (4, 4), textcoords="offset points", fontsize=7, color=f"C{k}"
            )
    axes.set(xlabel="CPU time [s]")
    axes.grid(which="both", color="0.92", lw=0.6)
    axes.legend(fontsize=8)
