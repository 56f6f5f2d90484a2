#!/usr/bin/python3
"""Reads exported scenes of programs that are not at hand, as those programs would.

    scripts/replays/files.py sofa|febio|gipsi|numpy build/springfit SCENE.prm [--set "Section/Entry=value"]...

Every element and attribute must be one that the program knows, and nodes, masses, springs, what is held
and the forces must be those of springfit's tables. Exit status 1 where they are not. Debian:
python3-numpy for numpy.
"""

import math
import pathlib
import re
import sys
import xml.etree.ElementTree

import results

# Components and the attributes that scenes use, from the headers of the versions.
OF_ALL_SOFAS = {
    "Node": {"name", "gravity", "dt"},
    "RequiredPlugin": {"pluginName"},
    "DefaultAnimationLoop": set(),
    "VisualStyle": {"displayFlags"},
    "EulerImplicitSolver": {"rayleighStiffness", "rayleighMass"},
    "SparseLDLSolver": {"template"},
    "MechanicalObject": {"name", "template", "position", "rest_position"},
    "DiagonalMass": {"vertexMass"},
    "ConstantForceField": {"indices", "forces"},
    "MeshTopology": {"name", "position", "tetrahedra"},
    "RestShapeSpringsForceField": {"template", "stiffness"},
}
OF_SOFA = {
    "23.12": {
        "StiffSpringForceField": {"name", "spring"},
        "FixedConstraint": {"indices"},
        "PartialFixedConstraint": {"indices", "fixedDirections"},
    },
    "24.06": {
        "SpringForceField": {"name", "spring"},
        "FixedProjectiveConstraint": {"indices"},
        "PartialFixedProjectiveConstraint": {"indices", "fixedDirections"},
    },
}
OF_SOFA["24.12"] = {
    **OF_SOFA["24.06"],
    "VolumeMapping": {"topology", "geometricStiffness", "applyRestPosition"},
}
OF_FEBIO = {
    "febio_spec": "Module Control Mesh MeshDomains MeshData Boundary Loads Discrete LoadData Output",
    "Control": "analysis time_steps step_size solver",
    "solver": "symmetric_stiffness dtol etol qn_method",
    "qn_method": "max_ups",
    "Mesh": "Nodes NodeSet DiscreteSet",
    "Nodes": "node",
    "DiscreteSet": "delem",
    "MeshData": "NodeData",
    "NodeData": "node",
    "Boundary": "bc",
    "bc": "dof value relative",
    "Loads": "nodal_load",
    "nodal_load": "dof scale relative",
    "Discrete": "discrete_material discrete",
    "discrete_material": "E",
    "LoadData": "load_controller",
    "load_controller": "interpolate points",
    "points": "pt",
    "Output": "plotfile logfile",
    "plotfile": "var",
    "logfile": "node_data",
}


class Tables:
    """What springfit says of a scene; the springs as a set without an order."""

    def __init__(self, folder, name):
        case, self.fit = name.split("_", 1)
        fit = self.fit
        rows = results.read_table(folder / "nodes.csv")
        self.nodes = [tuple(x) for x in results.vectors(rows, "")]
        self.mass = [float(row["mass"]) for row in rows]
        table = results.read_table(folder / f"{case}_{fit}.csv")
        self.is_plane = "set Dimension        = 2" in (folder / "used.prm").read_text()
        self.held = [
            tuple(
                float(row["held_" + axis]) == 1.0 or (axis == "z" and self.is_plane)
                for axis in "xyz"
            )
            for row in table
        ]
        self.forces = [
            tuple(0.0 if held else f for f, held in zip(force, held_of_node))
            for force, held_of_node in zip(results.vectors(table, "force_"), self.held)
        ]
        # Supports are moved from where the nodes are at rest.
        self.support = [
            tuple(u if held else 0.0 for u, held in zip(moved, held_of_node))
            for moved, held_of_node in zip(results.vectors(table, "u_"), self.held)
        ]
        self.places = [
            tuple(x + u for x, u in zip(*pair)) for pair in zip(self.nodes, self.support)
        ]
        self.springs = sorted(
            (int(row["i"]), int(row["j"]), float(row["k"]), float(row["rest_length"]))
            for row in results.read_table(folder / f"springs_{fit}.csv")
        )

    def forces_of_nodes(self):
        return {n: f for n, f in enumerate(self.forces) if any(f)}


def check(what, ours, theirs):
    if ours != theirs:
        results.fail(f"{what} differ: {str(ours)[:300]}\nfrom {str(theirs)[:300]}")


def numbers(text, width):
    all_ = [float(word) for word in text.split()]
    return [tuple(all_[i : i + width]) for i in range(0, len(all_), width)]


def integers(text):
    return [int(word) for word in text.replace(",", " ").split()]


def sofa(path, tables, folder):
    root = xml.etree.ElementTree.parse(path).getroot()
    version = re.search(r"For SOFA ([0-9.]+)", path.read_text())[1]
    known = {**OF_ALL_SOFAS, **OF_SOFA[version]}
    for element in root.iter():
        if element.tag not in known or not set(element.attrib) <= known[element.tag]:
            results.fail(f"SOFA {version} does not know {element.tag} {element.attrib.keys()}")
    network = root.find("Node")

    def attribute(tag, name):
        found = [e for e in network if e.tag.endswith(tag)]
        return found[0].get(name) if found else ""

    check("nodes", tables.places, numbers(attribute("MechanicalObject", "position"), 3))
    check("masses", tables.mass, [m for m, in numbers(attribute("DiagonalMass", "vertexMass"), 1)])
    springs = numbers(attribute("ringForceField", "spring"), 5)
    check("springs", tables.springs, sorted((int(i), int(j), k, L) for i, j, k, _, L in springs))
    held = [(False, False, False)] * len(tables.nodes)
    for element in network:
        if element.tag.endswith("Constraint"):
            directions = element.get("fixedDirections", "1 1 1").split()
            for node in integers(element.get("indices")):
                held[node] = tuple(d == "1" for d in directions)
    check("supports", tables.held, held)
    nodes = integers(attribute("ConstantForceField", "indices"))
    forces = numbers(attribute("ConstantForceField", "forces"), 3)
    check("forces", tables.forces_of_nodes(), dict(zip(nodes, forces)))
    volumes = network.find("Node")
    fit = tables.fit
    if (folder / f"volumes_{fit}.csv").exists():
        rows = results.read_table(folder / f"volumes_{fit}.csv")
        topology = integers(attribute("MeshTopology", "tetrahedra"))
        check("cells", [int(row[f"n{a}"]) for row in rows for a in range(4)], topology)
        for tag, name, column in (
            ("MechanicalObject", "rest_position", "rest_volume"),
            ("RestShapeSpringsForceField", "stiffness", "k"),
        ):
            text = volumes.find(tag).get(name)
            check(column, [float(row[column]) for row in rows], [v for v, in numbers(text, 1)])


def febio(path, tables, _):
    root = xml.etree.ElementTree.parse(path).getroot()
    for element in root.iter():
        for child in element:
            if child.tag not in OF_FEBIO.get(element.tag, "").split():
                results.fail(f"FEBio does not know {child.tag} in {element.tag}")
    nodes = [tuple(map(float, e.text.split(","))) for e in root.iterfind("Mesh/Nodes/node")]
    check("nodes", tables.nodes, nodes)
    sets = {e.get("name"): [n - 1 for n in integers(e.text)] for e in root.iterfind("Mesh/NodeSet")}
    for d, axis in enumerate("xyz"):
        held = [n for n, of_node in enumerate(tables.held) if of_node[d]]
        check("supports", held, sets.get("held_" + axis, []))
    maps = {
        e.get("name"): [float(v.text) for v in e] for e in root.iterfind("MeshData/NodeData")
    }
    for d, axis in enumerate("xyz"):
        moved = [tables.support[n][d] for n in sets.get("held_" + axis, [])]
        check("moved supports", moved, maps.get("support_" + axis, []))
    if "loaded" in sets:
        forces = zip(*(maps["force_" + axis] for axis in "xyz"))
        check("forces", tables.forces_of_nodes(), dict(zip(sets["loaded"], forces)))
    springs = []
    k_of = {e.get("id"): float(e.find("E").text) for e in root.iterfind("Discrete/discrete_material")}
    material = {e.get("discrete_set"): e.get("dmat") for e in root.iterfind("Discrete/discrete")}
    for element in root.iterfind("Mesh/DiscreteSet"):
        for pair in element:
            i, j = (n - 1 for n in integers(pair.text))
            springs.append((i, j, k_of[material[element.get("name")]]))
    check("springs", [s[:3] for s in tables.springs if s[2] != 0.0], sorted(springs))
    for i, j, _, rest_length in tables.springs:
        # FEBio's rest lengths are distances.
        distance = math.dist(nodes[i], nodes[j])
        check("rest lengths", True, abs(distance - rest_length) <= 1e-9 * distance)


def gipsi(path, tables, _):
    lines = [line.split() for line in path.read_text().splitlines()]
    counts = [int(word) for word in lines[0][1:]]
    kinds = {kind: [words[1:] for words in lines[1:] if words[0] == kind] for kind in "mgsvb"}
    check("counts", counts, [len(kinds[kind]) for kind in "mgsvb"])
    last_mass = max(n for n, words in enumerate(lines) if words[0] == "m")
    if any(words[0] == "#" for words in lines[last_mass:]):
        results.fail("a comment behind the masses")
    masses = [tuple(map(float, words)) for words in kinds["m"]]
    check("nodes", [(m, *x) for m, x in zip(tables.mass, tables.places)], masses)
    springs = [(int(i) - 1, int(j) - 1, float(k), float(L)) for i, j, k, _, L in kinds["s"]]
    check("springs", tables.springs, sorted(springs))
    held = [n + 1 for n, of_node in enumerate(tables.held) if all(of_node)]
    check("supports", held, [int(n) for n, in kinds["b"]])


def numpy(path, tables, folder):
    import numpy as np

    arrays = np.load(path)
    check("nodes", tables.nodes, [tuple(x) for x in arrays["nodes"].tolist()])
    check("moved supports", tables.support, [tuple(u) for u in arrays["support"].tolist()])
    check("masses", tables.mass, arrays["mass"].tolist())
    check("supports", tables.held, [tuple(n) for n in arrays["held"].astype(bool).tolist()])
    check("forces", tables.forces, [tuple(f) for f in arrays["forces"].tolist()])
    fit = tables.fit
    names = {"nodes", "mass", "held", "support", "forces"}
    for row in results.read_table(folder / "families.csv"):
        if row["fit"] != fit:
            continue
        members = results.read_table(folder / row["file"])
        width = int(row["numbers_of_member"])
        n = int(row["n_nodes_of_member"])
        columns = [row["column"] + (str(w) if width > 1 else "") for w in range(width)]
        array = arrays[row["family"] + "_" + row["column"]].reshape(len(members), width)
        check(row["column"], [[float(m[c]) for c in columns] for m in members], array.tolist())
        nodes = arrays[row["family"] + "_nodes"].reshape(len(members), n)
        check("members", [[int(v) for v in list(m.values())[:n]] for m in members], nodes.tolist())
        check("law", row["law"], str(arrays[row["family"] + "_law"]))
        names |= {row["family"] + "_" + what for what in (row["column"], "nodes", "law")}
    check("arrays", names, set(arrays.files))


FORMATS = {"sofa": (sofa, "scn"), "febio": (febio, "feb"), "gipsi": (gipsi, "msd"), "numpy": (numpy, "npz")}


def main(format_, program, scene, *arguments):
    read, ending = FORMATS[format_]
    entries = [word for word in arguments if word != "--set"]
    with results.scratch_folder() as scratch:
        folder = results.springfit(
            program, pathlib.Path(scene), scratch, [f"Output/Export={format_}", *entries]
        )
        for path, name in results.exported(folder, ending):
            read(path, Tables(folder, name), folder)
            print(f"{path.name}: as in the tables")


if __name__ == "__main__":
    if len(sys.argv) < 4 or sys.argv[1] not in FORMATS:
        sys.exit(__doc__)
    main(*sys.argv[1:])
