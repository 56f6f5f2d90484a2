#!/usr/bin/python3
"""CalculiX solves exported scenes, and finds the displacements that springfit has.

    scripts/replays/calculix.py build/springfit parameters/cube.prm [--set "Section/Entry=value"]...

Exit status 1 where they differ by more than 1e-6 of the largest displacement; ccx prints seven
digits. Debian: calculix-ccx.
"""

import sys

import results

LIMIT = 1e-6


def displacements(folder, name):
    output = results.run(["ccx", name], folder)
    if "*ERROR" in output:
        results.fail("ccx " + name + ":\n" + output[-3000:])
    found = {}
    for line in (folder / (name + ".dat")).read_text().splitlines():
        words = line.split()
        if len(words) == 4 and words[0].isdigit():
            found[int(words[0]) - 1] = [float(word) for word in words[1:]]
    return [found[node] for node in range(len(found))]


def main(program, scene, *arguments):
    entries = [word for word in arguments if word != "--set"]
    with results.scratch_folder() as scratch:
        folder = results.springfit(
            program, scene, scratch, ["Output/Export=calculix", *entries]
        )
        is_well = True
        for path, name in results.exported(folder, "inp"):
            ours = results.vectors(results.read_table(folder / (name + ".csv")), "u_")
            theirs = displacements(folder, path.stem)
            is_well &= results.tell(name, results.distance(ours, theirs), LIMIT)
        sys.exit(not is_well)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
