#!/usr/bin/python3
"""MuJoCo steps an exported scene of dynamics, and its nodes move as those of springfit.

    scripts/replays/mujoco.py build/mujoco_steps build/springfit [--set "Section/Entry=value"]...

A cantilever under a sudden load, by symplectic Euler in both, with true forces. Exit status 1 where a
place differs by more than 1e-6 of the largest displacement. Debian: libmujoco-dev.
"""

import math
import pathlib
import sys

import results

LIMIT = 1e-6
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
  set Export = mujoco
end
"""


def main(stepper, program, *arguments):
    entries = [word for word in arguments if word != "--set"]
    with results.scratch_folder() as scratch:
        scene = pathlib.Path(scratch) / "beam.prm"
        scene.write_text(SCENE)
        folder = results.springfit(program, scene, scratch, entries)
        nodes = results.vectors(results.read_table(folder / "nodes.csv"), "")
        tip = max(range(len(nodes)), key=lambda n: sum(nodes[n]))
        ours = results.read_table(folder / "own_frobenius_nonlinear_motion.csv")
        output = results.run(
            [pathlib.Path(stepper).resolve(), folder / "own_frobenius.xml", str(len(ours) - 1), str(tip)],
            folder,
        )
        theirs = [[float(word) for word in line.split()] for line in output.splitlines()]
        largest = distance = 0.0
        for row, (time, *place) in zip(ours[1:], theirs):
            if abs(float(row["time_s"]) - time) > 1e-9:
                results.fail(f"times differ: {row['time_s']} and {time} s")
            u = [float(row["u_tip_" + axis]) for axis in "xyz"]
            moved = [x - x_0 for x, x_0 in zip(place, nodes[tip])]
            largest = max(largest, math.hypot(*u))
            distance = max(distance, math.dist(u, moved))
        sys.exit(not results.tell(f"{len(theirs)} steps", distance / largest, LIMIT))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
