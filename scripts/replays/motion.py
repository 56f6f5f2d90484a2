#!/usr/bin/python3
"""MuJoCo and LAMMPS step an exported scene of dynamics, and its nodes move as those of springfit.

    scripts/replays/motion.py build/mujoco_steps build/springfit [--set "Section/Entry=value"]...

A cantilever under a sudden load. MuJoCo takes the same method, symplectic Euler's, and must have the
same places to 1e-6 of the largest displacement after every step. LAMMPS' velocity Verlet begins with half a
step where that has a whole one, and is to be within 0.01 % after 1e5 steps; the exact model, whose volumes
come by its library, within 1 % after 500. Debian: libmujoco-dev, lammps, python3-lammps, liblammps-dev.
"""

import math
import pathlib
import re
import sys

import results

LIMIT = 1e-6
LIMIT_OF_VERLET = 1e-4
LIMIT_OF_FEW_STEPS = 1e-2
SCENE = """
set Dimension = 3
set Study     = dynamics
subsection Geometry
  set Object    = box
  set Cells     = tetrahedra
  set Size      = 0.04, 0.01, 0.01
  set Cell size = 0.005
end
subsection Fit
  set Methods     = frobenius
  set Nonnegative = true
end
subsection Loads
  set Supports = where x < 1e-6
  set Gravity  = 0, 0, -9.81
end
subsection Response
  set Kinematics = nonlinear
end
subsection Dynamics
  set Integrator      = symplectic euler
  set Time step       = 1e-4
  set End time        = 0.1
  set Finite elements = false
  set Frame interval  = 0
  set Points          = tip: 0.04, 0.01, 0.01
end
subsection Output
  set Export = mujoco, lammps
end
"""


EXACT = [
    "Fit/Methods=stable neo-hookean",
    "Fit/Enrichment=volume",
    "Dynamics/End time=0.05",
    "Output/Export=lammps library",
]


def motion_of_tip(folder):
    (table,) = folder.glob("own_*_nonlinear_motion.csv")
    rows = results.read_table(table)
    return [(float(row["time_s"]), [float(row["u_tip_" + axis]) for axis in "xyz"]) for row in rows]


def by_mujoco(stepper, folder, tip, place_at_rest):
    ours = motion_of_tip(folder)
    output = results.run(
        [stepper, folder / "export_own_frobenius.xml", str(len(ours) - 1), str(tip)], folder
    )
    theirs = [[float(word) for word in line.split()] for line in output.splitlines()]
    largest = distance = 0.0
    for (our_time, u), (time, *place) in zip(ours[1:], theirs):
        if abs(our_time - time) > 1e-9:
            results.fail(f"times differ: {our_time} and {time} s")
        moved = [x - x_0 for x, x_0 in zip(place, place_at_rest)]
        largest = max(largest, math.hypot(*u))
        distance = max(distance, math.dist(u, moved))
    return results.tell(f"MuJoCo, {len(theirs)} steps", distance / largest, LIMIT)


def by_lammps(command, folder, tip, place_at_rest, limit):
    ours = motion_of_tip(folder)
    (scene,) = folder.glob("export_own_*.lmp")
    results.run([*command, scene.name], folder)
    dump = scene.with_suffix(".dump").read_text()
    if int(dump.split("ITEM: TIMESTEP")[1].split()[0]) != len(ours) - 1:
        results.fail("LAMMPS took another number of steps")
    row = dump.split("ITEM: ATOMS")[1].splitlines()[1 + tip].split()
    moved = [float(x) - x_0 for x, x_0 in zip(row[1:4], place_at_rest)]
    largest = max(math.hypot(*u) for _, u in ours)
    distance = math.dist(ours[-1][1], moved) / largest
    return results.tell(f"LAMMPS, after {len(ours) - 1} steps", distance, limit)


def has_stable_step(folder):
    """Of a scene whose own step is too large for explicit methods."""
    (scene,) = folder.glob("export_own_*.lmp")
    step = float(re.search(r"^timestep (.*)$", scene.read_text(), re.MULTILINE)[1])
    stable = float(results.read_table(folder / "stable_steps.csv")[0]["stable_step_s"])
    print(f"step in LAMMPS {step:.3g} s, stable {stable:.3g} s")
    return step < 0.75 * stable


def main(stepper, program, *arguments):
    entries = [word for word in arguments if word != "--set"]
    with results.scratch_folder() as scratch:
        scene = pathlib.Path(scratch) / "beam.prm"
        scene.write_text(SCENE)
        folder = results.springfit(program, scene, scratch, entries)
        nodes = results.vectors(results.read_table(folder / "nodes.csv"), "")
        tip = max(range(len(nodes)), key=lambda n: sum(nodes[n]))
        is_well = by_mujoco(pathlib.Path(stepper).resolve(), folder, tip, nodes[tip])
        folder = results.springfit(
            program, scene, scratch, [*entries, "Dynamics/Time step=1e-6"]
        )
        command = ["lmp", "-log", "none", "-in"]
        is_well &= by_lammps(command, folder, tip, nodes[tip], LIMIT_OF_VERLET)
        folder = results.springfit(program, scene, scratch, [*entries, *EXACT])
        is_well &= by_lammps([results.DRIVER], folder, tip, nodes[tip], LIMIT_OF_FEW_STEPS)
        long_steps = ["Dynamics/Integrator=implicit euler", "Dynamics/Time step=0.01"]
        folder = results.springfit(program, scene, scratch, [*entries, *EXACT, *long_steps])
        is_well &= has_stable_step(folder)
        sys.exit(not is_well)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
