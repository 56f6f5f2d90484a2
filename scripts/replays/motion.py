#!/usr/bin/python3
"""MuJoCo and LAMMPS step an exported scene of dynamics, and its nodes move as those of springfit.

    scripts/replays/motion.py build/mujoco_steps build/springfit [--set "Section/Entry=value"]...

A cantilever under a sudden load. MuJoCo takes the same method, symplectic Euler's, and must have the
same places to 1e-6 of the largest displacement after every step. LAMMPS' velocity Verlet begins with half a
step where that has a whole one, and is to be within 0.01 % after 1e5 steps. Debian: libmujoco-dev,
lammps.
"""

import math
import pathlib
import sys

import results

LIMIT = 1e-6
LIMIT_OF_VERLET = 1e-4
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


def motion_of_tip(folder):
    rows = results.read_table(folder / "own_frobenius_nonlinear_motion.csv")
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


def by_lammps(folder, tip, place_at_rest):
    ours = motion_of_tip(folder)
    results.run(["lmp", "-in", "export_own_frobenius.lmp", "-log", "none"], folder)
    dump = (folder / "export_own_frobenius.dump").read_text()
    if int(dump.split("ITEM: TIMESTEP")[1].split()[0]) != len(ours) - 1:
        results.fail("LAMMPS took another number of steps")
    row = dump.split("ITEM: ATOMS")[1].splitlines()[1 + tip].split()
    moved = [float(x) - x_0 for x, x_0 in zip(row[1:4], place_at_rest)]
    largest = max(math.hypot(*u) for _, u in ours)
    distance = math.dist(ours[-1][1], moved) / largest
    return results.tell(f"LAMMPS, after {len(ours) - 1} steps", distance, LIMIT_OF_VERLET)


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
        is_well &= by_lammps(folder, tip, nodes[tip])
        sys.exit(not is_well)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
