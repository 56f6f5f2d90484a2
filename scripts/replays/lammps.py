#!/usr/bin/python3
"""LAMMPS solves exported scenes, and finds the displacements that springfit has.

    scripts/replays/lammps.py build/springfit parameters/cube.prm [--set "Section/Entry=value"]...

With true forces as it is; small displacements from two pairs of small loads, in whose differences what
grows with the square and the cube of the load cancels (not where supports move). Exit status 1 where they
differ by more than 1e-6 of the largest displacement. With "Output/Export=lammps library" the library of
LAMMPS is driven by examples/run_in_lammps.py. Debian: lammps, python3-lammps, liblammps-dev.
"""

import sys

import results

LIMIT = 1e-6
SMALL = 4e-3


def places(folder, name, load):
    script = name + ".lmp"
    program = [results.DRIVER, script] if name.endswith("_library") else ["lmp", "-in", script, "-log", "none"]
    results.run([*program, "-var", "load", str(load)], folder)
    rows = (folder / (name + ".dump")).read_text().split("ITEM: ATOMS")[1].splitlines()[1:]
    return [[float(word) for word in row.split()[1:4]] for row in rows]


def difference(a, b, scale):
    return [[(y - x) / scale for x, y in zip(p, q)] for p, q in zip(a, b)]


def small_displacements(folder, name):
    odd = [
        difference(places(folder, name, -load), places(folder, name, load), 2 * load)
        for load in (SMALL, 2 * SMALL)
    ]
    return [[(4 * x - y) / 3 for x, y in zip(p, q)] for p, q in zip(*odd)]


def supports_move(table):
    return any(float(r["held_" + a]) and float(r["u_" + a]) for r in table for a in "xyz")


def main(program, scene, *arguments):
    entries = [word for word in arguments if word != "--set"]
    with results.scratch_folder() as scratch:
        folder = results.springfit(
            program, scene, scratch, ["Output/Export=lammps", *entries]
        )
        nodes = results.vectors(results.read_table(folder / "nodes.csv"), "")
        is_well, n_compared = True, 0
        for path, name in results.exported(folder, "lmp"):
            name = name.removesuffix("_library")
            linear, nonlinear = folder / (name + ".csv"), folder / (name + "_nonlinear.csv")
            if nonlinear.exists():
                n_compared += 1
                ours = results.vectors(results.read_table(nonlinear), "u_")
                theirs = difference(nodes, places(folder, path.stem, 1), 1)
                is_well &= results.tell(
                    name + ", true forces", results.distance(ours, theirs), LIMIT
                )
            if linear.exists() and not supports_move(results.read_table(linear)):
                n_compared += 1
                ours = results.vectors(results.read_table(linear), "u_")
                theirs = small_displacements(folder, path.stem)
                is_well &= results.tell(
                    name + ", small displacements", results.distance(ours, theirs), LIMIT
                )
        sys.exit(not (is_well and n_compared))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
