# ulphFoam: free-surface flow with updated Lagrangian particles
# SPDX-License-Identifier: GPL-3.0-or-later

"""Instructions of the pair passes in dumps of Test-effects.

Usage: effects.py callgrind.out...

Dumps come in pairs, library.<case> and bare.<case>. The pair passes of both
must be the same functions with the same number of instructions of their own;
what the sinks do with the sums is not theirs. The library may have one pass
more, that of the normals, unless no surface is looked for. Where every family
is none, the whole evaluation may take LARGEST_RATIO times the instructions of
the bare one, which neither looks whether the lists still hold nor keeps a ledger.
"""

import re
import sys

PASS = re.compile(r"ulph::(geometry|force|interpolation)Pass<(.*?)>\(")
LARGEST_RATIO = 1.1


def read(path):
    """Return the name of a dump and its own instructions by function."""
    name, total, function, names, costs = None, 0, None, {}, {}
    skip = False
    with open(path) as dump:
        for line in dump:
            if line.startswith("desc: Trigger:"):
                name = line.split("Client Request:")[-1].strip()
            elif line.startswith("fn="):
                number, _, text = line[3:].strip().partition(" ")
                if text:
                    names[number] = text
                function = names[number]
            elif line.startswith("cfn="):
                number, _, text = line[4:].strip().partition(" ")
                if text:
                    names[number] = text
            elif line.startswith("calls="):
                skip = True
            elif function and line[0] in "0123456789+-*":
                if not skip:
                    cost = int(line.split()[1])
                    costs[function] = costs.get(function, 0) + cost
                    total += cost
                skip = False
    return name, total, costs


def passes(costs):
    """Return the instructions of the pair passes by template arguments."""
    found = {}
    for function, cost in costs.items():
        match = PASS.search(function)
        if match:
            key = match.group(1) + " " + match.group(2)
            found[key] = found.get(key, 0) + cost
    return found


def is_of_normals(key):
    """Is this the pass of moments and gradient alone?"""
    return key.startswith("geometry") and key.endswith(", 3u")


def main(paths):
    dumps = {}
    for path in paths:
        name, total, costs = read(path)
        if name and costs:
            dumps[name] = (total, costs)

    compared = failed = 0
    for name in sorted(dumps):
        side, _, case = name.partition(".")
        if side != "library" or "bare." + case not in dumps:
            continue
        total, costs = dumps[name]
        bare_total, bare_costs = dumps["bare." + case]
        library, bare = passes(costs), passes(bare_costs)
        normals = [key for key in library if is_of_normals(key)]
        extra = sum(library.pop(key) for key in normals)

        all_none = case.startswith(("allNone", "omitted"))
        no_surface = all_none or case.startswith("freeSurfaceNone")
        good = (
            library == bare
            and len(bare) == 2
            and not (no_surface and normals)
            and not (all_none and total > LARGEST_RATIO*bare_total)
        )
        compared += 1
        failed += not good
        print(
            f"{'PASS' if good else 'FAIL'}  {case}: pair passes"
            f" {sum(library.values())} instructions, bare {sum(bare.values())},"
            f" normals {extra}, everything {total}, bare {bare_total},"
            f" ratio {total/bare_total:.3f}"
        )
        if not good:
            print("    library", library, "\n    bare", bare)

    print(f"{compared - failed} passed, {failed} failed")
    return 0 if compared and not failed else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
