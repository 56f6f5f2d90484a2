"""What scripts/enrichments runs: objects with all enrichments, fits of whole objects, large
deformations, and single cells."""
import dataclasses

from experiments import Experiment, scene_of

POISSON = (0., 0.25, 0.3, 0.45, 0.49)
JITTER = {"regular": 0., "distorted": 0.2}
FITS = ("frobenius", "consistent")
ENRICHMENTS = ("none", "volume", "angles", "coupling")
EXACT = ("stable neo-hookean", ("volume", "point volumes"))
OBJECTS = (("square", "triangles"), ("square", "quadrilaterals"), ("cube", "tetrahedra"),
           ("cube", "hexahedra"))

# Fits of all springs at once beside those of cells, on the same mesh: methods and
# further options. The equations of compliance are dense: of the hexahedra a
# coarser cube, 4 x 4 x 4.
SCOPES = {
    "cell": (FITS, ()),
    "object": (("frobenius", "consistent", "compliance"), ("Fit/Scope=object",)),
    "object, smooth fields": (("consistent",), ("Fit/Scope=object",
                                                "Fit/Fields=affine, quadratic")),
}
COARSER = {("cube", "hexahedra"): ("Geometry/Cell size=0.005",)}

# The same on the objects of the paper, of tetrahedra above all. Of the specimen of
# hexahedra the equations of compliance are too many.
PAPER_OBJECTS = (("cylinder", "tetrahedra", "regular"),
                 ("hollow cylinder", "tetrahedra", "regular"),
                 ("cube", "tetrahedra", "regular"), ("specimen", "tetrahedra", "regular"),
                 ("specimen", "quadrilaterals", "regular"),
                 ("specimen", "quadrilaterals", "distorted"),
                 ("specimen", "hexahedra", "regular"), ("specimen", "hexahedra", "distorted"))
PAPER_SCOPES = ("cell", "object")
TOO_LARGE = {("specimen", "hexahedra"): ("compliance",)}

# Pulled and sheared by 30 %: fits at rest, and over the state that the pulled object is in
# as well. (Of a neo-Hookean material biquadratic springs so fitted buckle when sheared.)
LARGE = (  # material law, spring law, loads
    ("st venant-kirchhoff", "quadratic", ("tension", "shear")),
    ("st venant-kirchhoff", "biquadratic", ("tension", "shear")),
    ("neo-hookean", "quadratic", ("tension", "shear")),
    ("neo-hookean", "biquadratic", ("tension",)),
)
PULLED = {2: "stretch x 1.3 y 0.9", 3: "stretch x 1.3 y 0.9 z 0.9"}

# Figure 9: what a regular cell delivers, over nu_in and along an axis. The edges of
# a regular tetrahedron are face diagonals of a cube.
SIMPLICES = ("triangles", "tetrahedra")
TWO_CELLS = ("triangles", "quadrilaterals")
SETTINGS = {  # picture: its panels (title, scene, options)
    f"plane_{state}": [(f"{cells}, plane {state}", "sweep_quadrilateral",
                        (f"Geometry/Cells={cells}", f"Material/Plane state={state}"))
                       for cells in TWO_CELLS] for state in ("stress", "strain")}
SETTINGS["space"] = [("hexahedra", "sweep_hexahedron", ())] + [
    (f"tetrahedra, pulled {title}", "sweep_hexahedron",
     ("Geometry/Cells=tetrahedra", f"Sweep/Axis={axis}"))
    for title, axis in (("along an edge", "1, 0, 0"),
                        ("along an edge of the cube around it", "0, 1.4142135623730951, 1"),
                        ("along a diagonal of that cube", "0, 0, 1"))]
SWEPT = "0 to 0.49 in 50"
SWEPT_ENRICHMENTS = ("none", "volume", "coupling")


@dataclasses.dataclass
class Run(Experiment):
    """One run of springfit; of an object, one material and mesh."""
    mesh: str = ""          # a word of JITTER
    nu: float = 0.
    scope: str = "cell"
    title: str = ""         # of a sweep or a row


def cases_of(cells):
    return ("tension", "shear") if cells in TWO_CELLS else ("tension", "shear", "torsion")


def fit_options(methods, enrichments):
    return (f"Fit/Methods={', '.join(methods)}", f"Fit/Enrichment={', '.join(enrichments)}",
            "Fit/Nonnegative=true")


def _objects(role, scope, of_fit, coarser=()):
    for object_, cells in OBJECTS:
        for mesh, jitter in JITTER.items():
            for nu in POISSON:
                name = f"{role}_{scope}_{object_}_{cells}_{mesh}_{nu:.2f}"
                options = of_fit + (f"Loads/Cases={', '.join(cases_of(cells))}",)
                options += dict(coarser).get((object_, cells), ())
                options += (f"Geometry/Jitter={jitter:g}", f"Material/Poisson's ratio={nu:g}")
                yield Run(name.replace(", ", "_").replace(" ", "_"), scene_of(object_, cells),
                          object_, cells, role, True, options=options, mesh=mesh, nu=nu,
                          scope=scope)


def _paper_objects():
    """A run for each fit: one may fail, and each has its time."""
    for object_, cells, mesh in PAPER_OBJECTS:
        for scope in PAPER_SCOPES:
            methods, more = SCOPES[scope]
            for method in methods:
                if method in TOO_LARGE.get((object_, cells), ()):
                    continue
                yield Run(f"paper_{scope}_{method}_{object_}_{cells}_{mesh}".replace(" ", "_"),
                          scene_of(object_, cells), object_, cells, "paper", True,
                          options=fit_options((method,), ("volume",)) + more + (
                              f"Loads/Cases={', '.join(cases_of(cells))}",
                              f"Geometry/Jitter={JITTER[mesh]:g}",
                              "Material/Poisson's ratio=0.3"),
                          mesh=mesh, nu=0.3, scope=scope, title=f"{method} + volume")


def _large_deformations():
    for object_, cells in OBJECTS:
        dim = 2 if cells in TWO_CELLS else 3
        for law, spring_law, cases in LARGE:
            for fitted, states in (("at rest", ""), ("stretched too", PULLED[dim])):
                # Of other cells no tangents tell all couplings apart.
                coupling = ("coupling",) if not states or cells in SIMPLICES else ()
                options = fit_options(("frobenius",), ("none", "volume") + coupling)
                options += COARSER.get((object_, cells), ())
                options += (f"Fit/Spring law={spring_law}", f"Fit/States={states}",
                            f"Loads/Cases={', '.join(cases)}", "Loads/Deformation=0.3",
                            "Response/Kinematics=nonlinear", f"Response/Material law={law}")
                title = f"{spring_law}, {fitted}"
                name = f"large_{cells}_{law}_{title}".replace(", ", "_").replace(" ", "_")
                yield Run(name, scene_of(object_, cells), object_, cells, "large", True,
                          options=options, law=law, nu=0.3, title=title)


def all_runs():
    fit, enrichments = EXACT
    runs = list(_objects("enrichments", "cell", fit_options(
        FITS + (fit,), ENRICHMENTS + tuple(set(enrichments) - set(ENRICHMENTS)))))
    for scope, (methods, more) in SCOPES.items():
        runs += _objects("scopes", scope, fit_options(methods, ("volume",)) + more, COARSER)
    runs += _paper_objects()
    runs += _large_deformations()
    for picture, panels in SETTINGS.items():
        for number, (title, scene, options) in enumerate(panels):
            options = fit_options(("consistent",), SWEPT_ENRICHMENTS) + options + (
                "Sweep/Young's moduli=1e4", f"Sweep/Poisson's ratios={SWEPT}")
            runs.append(Run(f"sweep_{picture}_{number}", f"parameters/{scene}.prm",
                            "one cell", role="sweep", nonnegative=True, options=options,
                            title=title))
    return runs


def command(run, nu=None, jitter=None):
    """What a reader types for the run; with 'nu' or 'jitter' to put in."""
    words = [f"scripts/run {run.scene}"]
    for option in run.options:
        entry, value = option.split("=", 1)
        value = {"Material/Poisson's ratio": nu, "Geometry/Jitter": jitter}.get(entry) or value
        words.append(f'--set "{entry}={value}"')
    lines = [words[0]]
    for word in words[1:]:
        if len(lines[-1]) + len(word) > 84:
            lines[-1] += " \\"
            lines.append("  " + word)
        else:
            lines[-1] += " " + word
    return "\n".join("    " + line for line in lines) + "\n"
