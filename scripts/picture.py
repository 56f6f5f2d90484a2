# Renders the results of a comparison, as doc/cube.png:
#
#   pvbatch scripts/picture.py output/cube torsion spectral doc/cube.png
#
# Left, the finite elements, coloured by displacement; middle, the springs of a
# fit (or frobenius_nonlinear), coloured by stiffness; right, the error of the
# fit. The displacements are drawn 3 times as large, or as a number behind the
# picture's name says.
#
# Or a network at rest, coloured by its first column (of springs the stiffness):
#
#   pvbatch scripts/picture.py --network output/cube/springs_spectral.vtu springs.png
#
# Or a motion as an animation, true to scale, coloured by displacement:
#
#   pvbatch scripts/picture.py --movie output/swing/own_frobenius.pvd swing.gif
#
# A .gif or .mp4 is made by ffmpeg; any other name is a folder for the frames as
# PNG. Debian's packages: apt-get install paraview python3-paraview, ffmpeg for a
# movie; on a machine without a screen xvfb too, and xvfb-run -a pvbatch ...
import itertools
import pathlib
import subprocess
import sys
import tempfile

try:
    from paraview.simple import *
except ImportError:
    sys.exit("picture.py: ParaView is missing. Install it: "
             "apt-get install paraview python3-paraview xvfb\n"
             "Then: xvfb-run -a pvbatch scripts/picture.py ...")

usage = """usage: pvbatch scripts/picture.py FOLDER CASE FIT PICTURE.png [TIMES], such as
         output/cube torsion spectral cube.png 3
or     pvbatch scripts/picture.py --network FOLDER/springs_FIT.vtu PICTURE.png
or     pvbatch scripts/picture.py --movie SERIES.pvd MOVIE.gif
Without a screen: xvfb-run -a pvbatch ...; Debian's packages are paraview, python3-paraview,
xvfb, and ffmpeg for movies."""

BAR, TITLE = 0.2, 0.08  # parts of a view's height


def coloured(source, data, array, title, view, representation, value_range=None):
    """Show a source in a view with a bar that explains its colours; white is 0 where
    there are negative numbers."""
    display = Show(source, view)
    display.Representation = representation
    display.LineWidth = 2 if representation == "Wireframe" else 1
    ColorBy(display, (data, array))
    table = GetColorTransferFunction(array)
    if value_range is None:
        found = source.CellData if data == "CELLS" else source.PointData
        n_components = found[array].GetNumberOfComponents()
        value_range = found[array].GetRange(-1 if n_components > 1 else 0)
    low, high = value_range
    if low < 0 < high:
        low, high = -max(-low, high), max(-low, high)
        table.ApplyPreset("Cool to Warm", True)
    else:
        table.ApplyPreset("Viridis (matplotlib)", True)
    table.RescaleTransferFunction(low, high)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize = bar.LabelFontSize = 18
    bar.Orientation, bar.WindowLocation = "Horizontal", "Lower Center"
    bar.ScalarBarLength = 0.7
    bar.AutomaticLabelFormat, bar.LabelFormat = 0, "%-#.2g"
    bar.RangeLabelFormat = "%-#.2g"
    bar.UseCustomLabels = 1
    bar.CustomLabels = [(low + high) / 2]
    display.SetScalarBarVisibility(view, True)


def white(view):
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    return view


def written(text, view):
    display = Show(Text(Text=text), view)
    display.Color = [0, 0, 0]
    display.FontSize = 18
    display.WindowLocation = "Upper Center"


def look_at(view, box, width, height):
    """Put a box between the bar and the title of a view of this size: a plane from above,
    anything else from the front, somewhat aside."""
    def unit(a):
        return [x / sum(y * y for y in a) ** 0.5 for x in a]

    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]

    size = max(box[i + 1] - box[i] for i in (0, 2, 4)) or 1.
    is_plane = box[5] - box[4] < 1e-6 * size
    towards = [0., 0., 1.] if is_plane else unit((2.4, -2.2, 1.5))
    right = [1., 0., 0.] if is_plane else unit(cross([0, 0, 1], towards))
    up = cross(towards, right)

    def extent(axis):
        places = [sum(x * a for x, a in zip(corner, axis))
                  for corner in itertools.product(box[0:2], box[2:4], box[4:6])]
        return min(places), max(places)

    (left, end), (bottom, top) = extent(right), extent(up)
    free = 1. - BAR - TITLE
    full = 1.06 * max((top - bottom) / free, (end - left) * height / width)
    middle = (bottom + top) / 2 - (BAR - TITLE) / 2 * full
    depth = sum((box[i] + box[i + 1]) / 2 * d for i, d in zip((0, 2, 4), towards))
    view.CameraParallelProjection = 1
    view.CameraParallelScale = full / 2
    view.CameraFocalPoint = [(left + end) / 2 * r + middle * u + depth * t
                             for r, u, t in zip(right, up, towards)]
    view.CameraPosition = [x + 10 * size * t for x, t in zip(view.CameraFocalPoint, towards)]
    view.CameraViewUp = up


def bounds(source):
    source.UpdatePipeline()
    return source.GetDataInformation().GetBounds()


def read(path):
    data = XMLUnstructuredGridReader(FileName=[str(path)])
    data.UpdatePipeline()
    return data


def picture_of_comparison(folder, case, fit, picture, times):
    width, height = 450, 560
    network = fit[:-len("_nonlinear")] if fit.endswith("_nonlinear") else fit
    for needed in (f"{case}_fem", f"{case}_{fit}", f"springs_{network}"):
        if not (pathlib.Path(folder) / f"{needed}.vtu").exists():
            there = sorted(file.stem for file in pathlib.Path(folder).glob("*.vtu"))
            sys.exit(f"picture.py: there is no {needed}.vtu in {folder}, but: "
                     + ", ".join(there))

    def warped(file, vector):
        data = read(f"{folder}/{file}.vtu")
        result = WarpByVector(Input=data, Vectors=["POINTS", vector], ScaleFactor=times)
        result.UpdatePipeline()
        return result

    layout = CreateLayout("picture")
    layout.SplitHorizontal(0, 0.3333)
    layout.SplitHorizontal(2, 0.5)
    springs = warped(f"springs_{network}", f"displacement_{case}{fit[len(network):]}")
    fem = warped(f"{case}_fem", "displacement")
    panels = [(fem, "POINTS", "displacement", "finite elements: displacement, m", 1,
               "Surface With Edges"),
              (springs, "CELLS", "k", f"springs, {fit} fit: k, N/m", 5, "Wireframe"),
              (warped(f"{case}_{fit}", "displacement"), "POINTS", "error",
               "error of the springs, m", 6, "Surface With Edges")]
    boxes = [bounds(panel[0]) for panel in panels]
    box = [(min, max)[i % 2](b[i] for b in boxes) for i in range(6)]
    for source, data, array, title, cell, representation in panels:
        view = white(CreateRenderView())
        AssignViewToLayout(view, layout, cell)
        coloured(source, data, array, title, view, representation)
        written(f"{case}, displacements x {times:g}", view)
        look_at(view, box, width, height)
    layout.SetSize(3 * width, height)
    SaveScreenshot(picture, layout, ImageResolution=[3 * width, height])


def picture_of_network(path, picture):
    if not pathlib.Path(path).exists():
        sys.exit(f"picture.py: there is no {path}.")
    network = read(path)
    kind = pathlib.Path(path).stem.split("_")[0]
    array, unit = {"springs": ("k", "N/m"), "couplings": ("stiffness", "N/m"),
                   "angles": ("k", "N m")}.get(kind, (network.CellData[0].Name, ""))
    width, height = 720, 720
    view = white(CreateRenderView())
    view.ViewSize = [width, height]
    coloured(network, "CELLS", array, f"{array}, {unit}" if unit else array, view,
             "Wireframe" if unit else "Surface With Edges")
    n = network.GetDataInformation().GetNumberOfCells()
    written(f"{pathlib.Path(path).stem}, {n} in number", view)
    look_at(view, bounds(network), width, height)
    SaveScreenshot(picture, view, ImageResolution=[width, height])


def write_frames(series, folder):
    """One picture for each time of a series; all in the same colours."""
    width, height = 720, 560
    data = PVDReader(FileName=series)
    warped = WarpByVector(Input=data, Vectors=["POINTS", "displacement"], ScaleFactor=1)
    times = list(data.TimestepValues)
    boxes, largest = [], 0
    for time in times:
        warped.UpdatePipeline(time)
        boxes.append(warped.GetDataInformation().GetBounds())
        largest = max(largest, warped.PointData["displacement"].GetRange(-1)[1])

    view = white(CreateRenderView())
    view.ViewSize = [width, height]
    view.ViewTime = times[0]
    coloured(warped, "POINTS", "displacement", "displacement, m", view, "Surface With Edges",
             [0, largest])
    look_at(view, [(min, max)[i % 2](b[i] for b in boxes) for i in range(6)], width, height)
    for number, time in enumerate(times):
        view.ViewTime = time
        Render(view)
        SaveScreenshot(str(folder / f"frame_{number:05d}.png"), view,
                       ImageResolution=[width, height])


def movie(series, target):
    if not pathlib.Path(series).exists():
        sys.exit(f"picture.py: there is no {series}.")
    if not target.endswith((".gif", ".mp4")):
        pathlib.Path(target).mkdir(parents=True, exist_ok=True)
        return write_frames(series, pathlib.Path(target))
    with tempfile.TemporaryDirectory() as folder:
        write_frames(series, pathlib.Path(folder))
        # A palette of its own keeps a .gif from flickering.
        filters = (["-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse"]
                   if target.endswith(".gif") else ["-pix_fmt", "yuv420p"])
        subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-framerate", "25", "-i",
                        f"{folder}/frame_%05d.png"] + filters + [target], check=True)


arguments = sys.argv[1:]
if len(arguments) == 3 and arguments[0] == "--movie":
    movie(*arguments[1:])
elif len(arguments) == 3 and arguments[0] == "--network":
    picture_of_network(*arguments[1:])
elif len(arguments) in (4, 5) and not arguments[0].startswith("-"):
    picture_of_comparison(*arguments[:4], float(arguments[4]) if arguments[4:] else 3.)
else:
    sys.exit(usage)
