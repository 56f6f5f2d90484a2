#!/usr/bin/python3
"""The example of a reader agrees with springfit, for every family.

    check_reader.py SPRINGFIT SOURCE_FOLDER
"""

import importlib.util
import pathlib
import sys

program, source = sys.argv[1:]
source = pathlib.Path(source)
sys.path.append(str(source / "scripts" / "replays"))
import results  # noqa: E402

spec = importlib.util.spec_from_file_location("reader", source / "examples" / "read_network.py")
reader = importlib.util.module_from_spec(spec)
spec.loader.exec_module(reader)

BOX = ["Geometry/Object=box", "Geometry/Jitter=0.2", "Material/Poisson's ratio=0.4"]
CUBE = [*BOX, "Geometry/Size=0.02, 0.02, 0.02", "Geometry/Cell size=0.01"]
PLATE = [*BOX, "Geometry/Size=0.02, 0.02", "Geometry/Cell size=0.007"]
LOADS = ["Loads/Cases=tension", "Loads/Deformation=0.3", "Response/Kinematics=linear, nonlinear"]
FROBENIUS = ["Fit/Methods=frobenius", "Fit/Nonnegative=true"]
EXACT = ["Fit/Methods=stable neo-hookean"]
LOGARITHMIC = ["Fit/Volume law=logarithmic", "Material/Poisson's ratio=0.3"]

SCENES = [
    # dimension, cells, entries, fit
    (3, "hexahedra", [*CUBE, *FROBENIUS], "frobenius"),
    (3, "hexahedra", [*CUBE, *FROBENIUS, "Fit/Spring law=biquadratic"], "frobenius"),
    (3, "hexahedra", [*CUBE, *FROBENIUS, "Fit/Enrichment=angles"], "frobenius_angles"),
    (3, "tetrahedra", [*CUBE, *FROBENIUS, "Fit/Enrichment=coupling"], "frobenius_coupling"),
    (3, "tetrahedra", [*CUBE, *FROBENIUS, "Fit/Enrichment=coupling", "Fit/Spring law=biquadratic"], "frobenius_coupling"),
    (3, "tetrahedra", [*CUBE, *EXACT, "Fit/Enrichment=volume"], "stable_neo_hookean_volume"),
    (3, "hexahedra", [*CUBE, *EXACT, "Fit/Enrichment=volume"], "stable_neo_hookean_volume"),
    (3, "hexahedra", [*CUBE, *EXACT, "Fit/Enrichment=point volumes"], "stable_neo_hookean_point_volumes"),
    (3, "hexahedra", [*CUBE, *EXACT, "Fit/Enrichment=point volumes", *LOGARITHMIC], "stable_neo_hookean_point_volumes"),
    (2, "quadrilaterals", [*PLATE, *EXACT, "Fit/Enrichment=point volumes"], "stable_neo_hookean_point_volumes"),
    (2, "quadrilaterals", [*PLATE, *EXACT, "Fit/Enrichment=volume", *LOGARITHMIC, "Material/Plane state=strain"], "stable_neo_hookean_volume"),
    (2, "triangles", [*PLATE, *EXACT, "Fit/Enrichment=volume", *LOGARITHMIC, "Material/Plane state=stress"], "stable_neo_hookean_volume"),
    (2, "quadrilaterals", [*PLATE, *EXACT, "Fit/Enrichment=point volumes", *LOGARITHMIC, "Material/Plane state=stress"], "stable_neo_hookean_point_volumes"),
    (3, "triangles", [*PLATE, "Geometry/Jitter=0", *EXACT, *LOGARITHMIC, "Fit/Enrichment=volume", "Loads/Supports=x min; where x > -1: z"], "stable_neo_hookean_volume"),
    (3, "triangles", [*PLATE, "Geometry/Jitter=0", *EXACT, "Fit/Enrichment=volume", "Loads/Supports=x min; where x > -1: z"], "stable_neo_hookean_volume"),
]

families = set()
for dimension, cells, entries, fit in SCENES:
    with results.scratch_folder() as scratch:
        scene = pathlib.Path(scratch) / "scene.prm"
        scene.write_text(f"set Dimension = {dimension}\nset Study = compare\n")
        folder = results.springfit(
            program, scene, scratch, [f"Geometry/Cells={cells}", *LOADS, *entries]
        )
        families |= {
            (row["family"], row["law"]) for row in results.read_table(folder / "families.csv")
        }
        print(cells, *entries[-3:], fit)
        assert reader.main(folder, "tension", fit) < 1e-10
        assert reader.main(folder, "tension", fit, "nonlinear") < 1e-8

assert {("springs", "quadratic"), ("springs", "biquadratic"), ("couplings", "quadratic"),
        ("couplings", "biquadratic"), ("angles", "quadratic"), ("volumes", "quadratic"),
        ("logarithmic_volumes", "logarithmic"), ("point_volumes", "quadratic"),
        ("logarithmic_point_volumes", "logarithmic"),
        ("logarithmic_plane_stress_volumes", "logarithmic plane stress"),
        ("logarithmic_plane_stress_point_volumes", "logarithmic plane stress")} <= families, families
