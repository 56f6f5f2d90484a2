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
# movie; on a machine without a screen xvfb too, and xvfb-run -a -s -noreset pvbatch ...
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy
    from paraview import servermanager
    from paraview.simple import *
    from vtkmodules.util.numpy_support import vtk_to_numpy
except ImportError:
    sys.exit("picture.py: ParaView is missing. Install it: "
             "apt-get install paraview python3-paraview xvfb\n"
             "Then: xvfb-run -a -s -noreset pvbatch scripts/picture.py ...")

usage = """usage: pvbatch scripts/picture.py FOLDER CASE FIT PICTURE.png [TIMES], such as
         output/cube torsion spectral cube.png 3
or     pvbatch scripts/picture.py --network FOLDER/springs_FIT.vtu PICTURE.png
or     pvbatch scripts/picture.py --movie SERIES.pvd MOVIE.gif
Without a screen: xvfb-run -a -s -noreset pvbatch ...
Debian's packages are paraview, python3-paraview, xvfb, and ffmpeg for movies."""

UNITS = {"displacement": "m", "error": "m", "k": "N/m"}
BAR, TITLE = 0.2, 0.12  # parts of a view's height


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
    bar.AutomaticLabelFormat, bar.LabelFormat = 0, "%.3g"
    bar.RangeLabelFormat = "%.3g"
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


def axes_of_view(is_plane):
    """To the right, up and towards the eye: a plane is seen from above, anything else from
    the front, somewhat aside."""
    if is_plane:
        return numpy.eye(3)
    towards = numpy.array([2.4, -2.2, 1.5]) / numpy.linalg.norm([2.4, -2.2, 1.5])
    right = numpy.cross([0, 0, 1], towards)
    right /= numpy.linalg.norm(right)
    return numpy.array([right, numpy.cross(towards, right), towards])


def outermost_points(source):
    """Those that limit what is seen of a source, a row for each."""
    points = vtk_to_numpy(servermanager.Fetch(source).GetPoints().GetData()).astype(float)
    along = points @ numpy.concatenate([axes_of_view(True), axes_of_view(False)]).T
    return points[[*along.argmin(axis=0), *along.argmax(axis=0)]]


def look_at(view, points, width, height):
    """Put points between the bar and the title of a view of this size."""
    size = numpy.ptp(points, axis=0).max() or 1.
    axes = axes_of_view(is_plane=numpy.ptp(points[:, 2]) < 1e-6 * size)
    low, high = (points @ axes.T).min(axis=0), (points @ axes.T).max(axis=0)
    shown = 1.06 * max((high[1] - low[1]) / (1. - BAR - TITLE),
                       (high[0] - low[0]) * height / width)
    focus = (low + high - [0., (BAR - TITLE) * shown, 0.]) / 2 @ axes
    view.CameraParallelProjection = 1
    view.CameraParallelScale = shown / 2
    view.CameraFocalPoint = list(focus)
    view.CameraPosition = list(focus + 10 * size * axes[2])
    view.CameraViewUp = list(axes[1])


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
    panels = [("finite elements", fem, "POINTS", "displacement", 1, "Surface With Edges"),
              (fit, springs, "CELLS", "k", 5, "Wireframe"),
              (fit, warped(f"{case}_{fit}", "displacement"), "POINTS", "error", 6,
               "Surface With Edges")]
    points = numpy.concatenate([outermost_points(panel[1]) for panel in panels])
    for model, source, data, array, cell, representation in panels:
        view = white(CreateRenderView())
        AssignViewToLayout(view, layout, cell)
        coloured(source, data, array, f"{array}, {UNITS[array]}", view, representation)
        written(f"{model}\n{case}, displacements x {times:g}", view)
        look_at(view, points, width, height)
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
    look_at(view, outermost_points(network), width, height)
    SaveScreenshot(picture, view, ImageResolution=[width, height])


def write_frames(series, folder):
    """One picture for each time of a series; all in the same colours."""
    width, height = 720, 560
    data = PVDReader(FileName=series)
    warped = WarpByVector(Input=data, Vectors=["POINTS", "displacement"], ScaleFactor=1)
    times = list(data.TimestepValues)
    points, largest = [], 0
    for time in times:
        warped.UpdatePipeline(time)
        points.append(outermost_points(warped))
        largest = max(largest, warped.PointData["displacement"].GetRange(-1)[1])

    view = white(CreateRenderView())
    view.ViewSize = [width, height]
    view.ViewTime = times[0]
    coloured(warped, "POINTS", "displacement", "displacement, m", view, "Surface With Edges",
             [0, largest])
    look_at(view, numpy.concatenate(points), width, height)
    for number, time in enumerate(times):
        view.ViewTime = time
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
