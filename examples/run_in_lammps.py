#!/usr/bin/python3
"""Runs a scene of 'Export = lammps library' by the library of LAMMPS.

    examples/run_in_lammps.py RESULTS/export_tension_stable_neo_hookean_volume_library.lmp [-var load 0.5]

LAMMPS moves the nodes and knows springs and angles. What it does not know, volumes and couplings, acts
through its `fix external`: here by numpy and complex steps, for meshes of some hundred cells. Debian:
python3-lammps, liblammps-dev, python3-numpy.
"""

import os
import re
import sys
import traceback

import numpy as np
from lammps import lammps

import read_network


def main(path, *arguments):
    folder, name = os.path.split(path)
    os.chdir(folder or ".")
    script = open(name).read()
    fit = re.search(r"^# Network: (\S+)$", script, re.MULTILINE)[1]
    nodes, network = read_network.read(".", fit)
    others = [family for family in network if family[0] not in ("springs", "angles")]
    program = lammps(cmdargs=["-log", "none", *arguments])

    def pull(_, step, n, tags, x, forces):
        # All nodes are on this process, in an order of its own; in the plane all z stay 0.
        order = tags.ravel() - 1
        places = np.empty_like(nodes)
        places[order] = x[:, : nodes.shape[1]]
        forces[:] = 0
        forces[:, : nodes.shape[1]] = read_network.forces(others, places)[order]
        program.fix_external_set_energy_global("others", read_network.energy(others, places))

    def pull_or_end(*arguments):
        # LAMMPS would go on without these forces.
        try:
            pull(*arguments)
        except Exception:
            traceback.print_exc()
            os._exit(1)

    for line in script.splitlines():
        program.command(line)
        if line.startswith("fix others "):
            program.set_fix_external_callback("others", pull_or_end)
    program.close()


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
