"""The pictures of the page, drawn by gnuplot as svg."""
import math
import re
import subprocess

from vtu import read_vtu

# Faces of cells by VTK's cell type.
FACES = {10: ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)),
         12: ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6),
              (3, 0, 4, 7))}
CAMERA = (-0.42, -0.80, 0.43)  # from the object to the eye
MANY_EDGES = 1000  # one panel only, to keep the pictures small
COLOURS = ("#4477aa", "#ee6677", "#228833", "#aa3377", "#ccbb44", "#66ccee", "#bbbbbb",
           "#000000")


def gnuplot(path, size, script):
    """Write a picture; a tenth of a point is fine enough for what is drawn."""
    head = (f"set terminal svg noenhanced size {size[0]},{size[1]} font 'sans,12' "
            f"background 'white'\nset output '{path}'\n")
    subprocess.run(["gnuplot"], input=head + script + "\nunset output\n", text=True,
                   check=True, capture_output=True)
    path.write_text(re.sub(r"<[^>]*>", lambda tag: re.sub(r"(\d+\.\d)\d+", r"\1", tag[0]),
                           path.read_text()))


def _sum(points):
    return [sum(p[d] for p in points) / len(points) for d in range(3)]


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def _project(point):
    right = _cross((0, 0, 1), CAMERA)
    right = [x / math.sqrt(_dot(right, right)) for x in right]
    up = _cross(CAMERA, right)
    length = math.sqrt(_dot(up, up))
    return _dot(point, right), _dot(point, up) / length


def _visible_faces(mesh):
    """Faces of the surface that look at the eye; a hole's, which look towards
    the object's axis (along x), do not count."""
    points = mesh.points
    axis = [(min(p[d] for p in points) + max(p[d] for p in points)) / 2 for d in range(3)]
    faces = {}
    for kind, cell in zip(mesh.types, mesh.cells):
        for face in FACES[kind]:
            nodes = [cell[v] for v in face]
            key = frozenset(nodes)
            faces[key] = None if key in faces else (nodes, _sum([points[n] for n in cell]))
    for nodes, inside in (face for face in faces.values() if face):
        a, b, c = (points[n] for n in nodes[:3])
        normal = _cross([y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)])
        centre = _sum([points[n] for n in nodes])
        if _dot(normal, [x - y for x, y in zip(centre, inside)]) < 0:
            normal = [-x for x in normal]
        outwards = [x / math.sqrt(_dot(normal, normal)) for x in normal]
        away = sum(outwards[d] * (centre[d] - axis[d]) for d in (1, 2))
        if _dot(normal, CAMERA) > 0 and away > -1e-6:
            yield nodes


def _edges(mesh):
    """Pairs of nodes, each edge once."""
    flat = mesh.types[0] in (5, 9)
    seen = {}
    for loop in mesh.cells if flat else _visible_faces(mesh):
        for a, b in zip(loop, [*loop[1:], loop[0]]):
            seen.setdefault(frozenset((a, b)), (a, b))
    return flat, list(seen.values())


def _trails(edges):
    """The edges joined to lines that run through each edge once."""
    left = {}
    for a, b in edges:
        left.setdefault(a, {})[b] = None
        left.setdefault(b, {})[a] = None
    for begin in [node for edge in edges for node in edge]:
        trail = [begin]
        while left[trail[-1]]:
            end, _ = left[trail[-1]].popitem()
            del left[end][trail[-1]]
            trail.append(end)
        if len(trail) > 1:
            yield trail


def _block(name, mesh, flat, trails):
    """A gnuplot data block of the deformed lines, in cm."""
    lines = [f"${name} << EOD"]
    for trail in trails:
        for node in trail:
            at = [100 * (x + u) for x, u in
                  zip(mesh.points[node], mesh.point_data["displacement"][node])]
            lines.append("%.3f %.3f" % (tuple(at[:2]) if flat else _project(at)))
        lines.append("")
    return "\n".join(lines + ["EOD"])


def deformed(folder, case, fits, titles, path):
    """Finite elements (dashed) over springs, one panel for each fit."""
    fem = read_vtu(folder / f"{case}_fem.vtu")
    flat, edges = _edges(fem)
    if len(edges) > MANY_EDGES:
        fits, titles = fits[:1], titles[:1]
    trails = list(_trails(edges))
    blocks = [_block("fem", fem, flat, trails)]
    panels = []
    for number, (fit, title) in enumerate(zip(fits, titles)):
        springs = read_vtu(folder / f"{case}_{fit}.vtu")
        blocks.append(_block(f"lem{number}", springs, flat, trails))
        panels.append(
            f"set title '{title}'\nplot $lem{number} with lines lw 2 lc '#9bc0e0' "
            f"title '{'springs' if number == 0 else ''}', $fem with lines dt (10,6) lw 0.8 "
            f"lc '#cc3311' title '{'finite elements' if number == 0 else ''}'")
    gnuplot(path, (380 * len(fits), 330), "\n".join(
        [*blocks, f"set multiplot layout 1,{len(fits)}",
         "set size ratio -1", "unset border", "unset tics",
         "set key at screen 0.5, screen 0.07 center horizontal",
         "set offsets graph 0.03, graph 0.03, graph 0.03, graph 0.12",
         *panels, "unset multiplot"]))


def sweep(cells, rows, path):
    """Figure 9: E_out over E_in, and nu_out over nu_in, of one cell; the rows
    are those of sweep.csv."""
    def name(row):
        return row["fit"] + ("" if row["enrichment"] == "none" else f" + {row['enrichment']}")

    def series(x, y, where):
        result = {}
        for row in rows:
            if where(row) and row[y]:
                result.setdefault(name(row), []).append((float(row[x]), float(row[y])))
        return {n: sorted(points) for n, points in result.items()}

    def panel(x, y, unit, curves, before):
        blocks, plots = [], []
        for number, (label, points) in enumerate(curves.items()):
            block = f"${y}_{number}"
            blocks += [f"{block} << EOD", *("%.6g %.6g" % p for p in points), "EOD"]
            shape = "dt 2 lw 2 lc 'black'" if label == "fem" else \
                f"lw 1.5 lc '{COLOURS[number % len(COLOURS)]}'"
            plots.append(f"{block} with lines {shape} title '{label}'")
        return "\n".join([*blocks, before, f"set xlabel '{x}{unit}'",
                          f"set ylabel '{y}{unit}'", "plot " + ", ".join(plots)])

    nu_in = min({float(r["nu_in"]) for r in rows}, key=lambda nu: abs(nu - 0.3))
    highest = max(float(r["E_in"]) for r in rows)
    gnuplot(path, (760, 320), "\n".join([
        "set multiplot layout 1,2", f"set title 'one cell, {cells}'",
        "set key left top samplen 1.5 font 'sans,9'", "set format xy '%g'",
        panel("E_in", "E_out", ", Pa",
              series("E_in", "E_out", lambda r: abs(float(r["nu_in"]) - nu_in) < 1e-9),
              "set logscale xy; unset mxtics; unset mytics"),
        panel("nu_in", "nu_out", "",
              series("nu_in", "nu_out", lambda r: float(r["E_in"]) == highest),
              "unset logscale; set xrange [0:0.5]; set yrange [-0.1:1.1]"),
        "unset multiplot"]))
