# Renders the results of a comparison, as doc/cube.png:
#
#   pvbatch scripts/picture.py output/cube torsion spectral doc/cube.png
#
# Left, the finite elements, coloured by displacement; middle, the springs of a
# fit (or frobenius_nonlinear), coloured by stiffness; right, the error of the
# fit. Deformation x 3.
#
# Or a motion as an animation, true to scale, coloured by displacement:
#
#   pvbatch scripts/picture.py --movie output/swing/own_frobenius.pvd swing.gif
#
# A .gif or .mp4 is made by ffmpeg; any other name is a folder for the frames as
# PNG. On a machine without a screen: xvfb-run -a pvbatch ...
import pathlib
import subprocess
import sys
import tempfile
from paraview.simple import *

usage = ("usage: pvbatch scripts/picture.py FOLDER CASE FIT PICTURE.png, such as "
         "output/cube torsion spectral cube.png\n"
         "or     pvbatch scripts/picture.py --movie SERIES.pvd MOVIE.gif")


def coloured(source, array, title, view, representation, value_range=None):
    """Show a source in a view with a bar that explains its colours."""
    display = Show(source, view)
    display.Representation = representation
    ColorBy(display, ("POINTS", array))
    table = GetColorTransferFunction(array)
    table.ApplyPreset("Viridis (matplotlib)", True)
    if value_range is None:
        display.RescaleTransferFunctionToDataRange(False, True)
    else:
        table.RescaleTransferFunction(*value_range)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize = bar.LabelFontSize = 18
    bar.Orientation, bar.WindowLocation = "Horizontal", "Lower Center"
    bar.ScalarBarLength = 0.7
    bar.AutomaticLabelFormat, bar.LabelFormat = 0, "%-#.2g"
    bar.RangeLabelFormat = "%-#.2g"
    bar.UseCustomLabels = 1
    low, high = display.LookupTable.RGBPoints[0], display.LookupTable.RGBPoints[-4]
    bar.CustomLabels = [(low + high) / 2]
    display.SetScalarBarVisibility(view, True)


def white(view):
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    return view


def look_from_the_front(view):
    camera = view.GetActiveCamera()
    camera.SetPosition(2.4, -2.2, 1.5)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    ResetCamera(view)
    camera.Zoom(0.78)


def panel(source, array, title, layout, cell, representation="Surface With Edges"):
    view = white(CreateRenderView())
    AssignViewToLayout(view, layout, cell)
    coloured(source, array, title, view, representation)
    look_from_the_front(view)


def picture_of_comparison(folder, case, fit, picture):
    network = fit[:-len("_nonlinear")] if fit.endswith("_nonlinear") else fit
    for needed in (f"{case}_fem", f"{case}_{fit}", f"springs_{network}"):
        if not (pathlib.Path(folder) / f"{needed}.vtu").exists():
            there = sorted(file.stem for file in pathlib.Path(folder).glob("*.vtu"))
            sys.exit(f"picture.py: there is no {needed}.vtu in {folder}, but: "
                     + ", ".join(there))

    def warped(file, vector):
        data = XMLUnstructuredGridReader(FileName=[f"{folder}/{file}.vtu"])
        data.UpdatePipeline()
        return WarpByVector(Input=data, Vectors=["POINTS", vector], ScaleFactor=3)

    layout = CreateLayout("picture")
    layout.SplitHorizontal(0, 0.3333)
    layout.SplitHorizontal(2, 0.5)
    panel(warped(f"{case}_fem", "displacement"), "displacement",
          "finite elements: displacement, m", layout, 1)
    springs = warped(f"springs_{network}",
                     f"displacement_{case}{fit[len(network):]}")
    panel(springs, "k", f"springs, {fit} fit: k, N/m", layout, 5, "Wireframe")
    panel(warped(f"{case}_{fit}", "displacement"), "error",
          "error of the springs, m", layout, 6)
    layout.SetSize(1350, 560)
    SaveScreenshot(picture, layout, ImageResolution=[1350, 560])


def write_frames(series, folder):
    """One picture for each time of a series; all in the same colours."""
    data = PVDReader(FileName=series)
    warped = WarpByVector(Input=data, Vectors=["POINTS", "displacement"], ScaleFactor=1)
    times = list(data.TimestepValues)
    boxes, largest = [], 0
    for time in times:
        warped.UpdatePipeline(time)
        boxes.append(warped.GetDataInformation().GetBounds())
        largest = max(largest, warped.PointData["displacement"].GetRange(-1)[1])
    box = [low_or_high(box[i] for box in boxes)
           for i, low_or_high in enumerate((min, max) * 3)]

    view = white(CreateRenderView())
    view.ViewSize = [720, 560]
    view.ViewTime = times[0]
    coloured(warped, "displacement", "displacement, m", view, "Surface With Edges",
             [0, largest])
    middle = [(low + high) / 2 for low, high in zip(box[::2], box[1::2])]
    size = sum((high - low) ** 2 for low, high in zip(box[::2], box[1::2])) ** 0.5
    view.CameraParallelProjection = 1
    middle[2] -= 0.08 * size  # room for the bar
    view.CameraFocalPoint = middle
    view.CameraPosition = [x + size * d for x, d in zip(middle, (2.4, -2.2, 1.5))]
    view.CameraViewUp = [0, 0, 1]
    view.CameraParallelScale = 0.45 * size
    for number, time in enumerate(times):
        view.ViewTime = time
        Render(view)
        SaveScreenshot(str(folder / f"frame_{number:05d}.png"), view,
                       ImageResolution=[720, 560])


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
elif len(arguments) == 4 and not arguments[0].startswith("-"):
    picture_of_comparison(*arguments)
else:
    sys.exit(usage)
