"""Running cases for the measurements in this folder, in the environment of
Make/bashrc."""

import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TUTORIALS = HERE.parents[1]/"tutorials"


def run(case, threads=1, command="ulphFoam", mayStop=False, ranks=1):
    """Text of a run's log, and its CPU seconds. A run that fails ends all, unless
    it may stop by itself."""
    words = [command, "-case", str(case)]
    if ranks > 1:
        words = ["mpirun", "-np", str(ranks), *words, "-parallel"]
    log = case/f"log.{command}"
    with open(log, "w") as out:
        process = subprocess.Popen(
            words, stdout=out, stderr=out,
            env={**os.environ, "OMP_NUM_THREADS": str(threads)})
        _, status, used = os.wait4(process.pid, 0)
    text = log.read_text()
    if status != 0 and not mayStop:
        sys.exit(f"{command} failed:\n" + text[-2000:])
    return text, used.ru_utime + used.ru_stime


def append(file, entries):
    with open(file, "a") as f:
        f.write("\n" + " ".join(f"{k} {v};" for k, v in entries.items()) + "\n")


def copyTutorial(folder, name, properties, controls):
    """A meshed copy of a tutorial with other entries."""
    case = folder/name
    for part in ("constant", "system"):
        shutil.copytree(TUTORIALS/name/part, case/part,
                        ignore=shutil.ignore_patterns("polyMesh"))
    append(case/"constant/ulphProperties", properties)
    append(case/"system/controlDict",
           {"startFrom": "startTime", **controls})
    run(case, 1, "blockMesh")
    return case
