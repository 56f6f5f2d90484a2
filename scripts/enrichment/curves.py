"""The pictures of the page, drawn by gnuplot as svg."""
from pictures import COLOURS, gnuplot
from scenes import ENRICHMENTS, FITS, JITTER, SWEPT_ENRICHMENTS

SHOWN = (0.3, 0.45, 0.49)   # of Poisson's ratios
LOWEST = 0.01               # %; what is smaller is drawn here


def _block(name, points):
    return "\n".join([f"{name} << EOD", *("%.6g %.6g" % p for p in points), "EOD"])


def error_and_cost(lines, path):
    """The largest e_rms of the load cases over the enrichments, which are in the
    order of their coefficients per cell, a panel for each mesh. 'lines' are those of
    one cell type."""
    panels = []
    for mesh in JITTER:
        blocks, plots, ticks = [], [], {}
        for number, nu in enumerate(SHOWN):
            for fit in FITS:
                points = []
                for line in lines:
                    if (line.mesh, line.fit) == (mesh, fit) and line.errors.get(nu):
                        ticks[line.enrichment] = line.coefficients
                        points.append((ENRICHMENTS.index(line.enrichment),
                                       max(LOWEST, *line.errors[nu].values())))
                name = f"${fit}_{mesh}_{number}"
                blocks.append(_block(name, sorted(points)))
                style = "pt 7" if fit == "consistent" else "pt 6 dt 2"
                plots.append(f"{name} with linespoints {style} ps 0.7 lw 1.2 "
                             f"lc '{COLOURS[number]}' title '{fit}, {nu:g}'")
        named = ", ".join(f"\"{word}\\n{ticks[word]:.1f}\" {place}" for place, word in
                          enumerate(ENRICHMENTS) if word in ticks)
        panels.append("\n".join(
            [*blocks, f"set title '{mesh}'", f"set xtics ({named}) nomirror",
             "plot " + ", ".join(plots)]))
    gnuplot(path, (760, 360), "\n".join(
        ["set multiplot layout 1,2", "set logscale y",
         f"set yrange [{0.7 * LOWEST}:150]", f"set xrange [-0.3:{len(ENRICHMENTS) - 0.7}]",
         "set format y '%g'", "set bmargin 5",
         "set ylabel 'largest e_rms, %'", "set grid ytics lc '#dddddd'",
         "set xlabel 'enrichment, coefficients per cell' offset 0,-1",
         "set key bottom left samplen 1.5 font 'sans,9'", *panels, "unset multiplot"]))


def figure_9(panels, path):
    """E_out / E_in and nu_out over nu_in; 'panels' are titles and rows of sweep.csv."""
    shown = []
    for number, (title, rows) in enumerate(panels):
        for y, label, scale in (("E", "E_out / E_in", "set logscale y; set yrange [0.5:20]"),
                                ("nu", "nu_out", "unset logscale; set yrange [-0.1:0.55]")):
            blocks, plots = [], []
            for place, enrichment in enumerate(SWEPT_ENRICHMENTS):
                points = [(float(r["nu_in"]), float(r["E_out"]) / float(r["E_in"])
                           if y == "E" else float(r["nu_out"])) for r in rows
                          if (r["fit"], r["enrichment"]) == ("consistent", enrichment)]
                name = f"${y}_{number}_{enrichment}"
                blocks.append(_block(name, points))
                words = "springs alone" if enrichment == "none" else f"+ {enrichment}"
                # Where volume and coupling agree, both are to be seen.
                style = "dt 2 lw 3" if enrichment == "coupling" else "lw 1.5"
                plots.append(f"{name} with lines {style} lc '{COLOURS[place]}' "
                             f"title '{words}'")
            shown.append("\n".join([*blocks, f"set title '{title}'", scale,
                                    f"set ylabel '{label}'", "plot " + ", ".join(plots)]))
    gnuplot(path, (760, 270 * len(panels)), "\n".join(
        [f"set multiplot layout {len(panels)},2", "set xrange [0:0.5]", "set xlabel 'nu_in'",
         "set format y '%g'", "set key top left samplen 1.5 font 'sans,9'", *shown,
         "unset multiplot"]))
