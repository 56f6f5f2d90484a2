# Renders the results of a comparison, as doc/cube.png:
#
#   pvbatch scripts/picture.py output/cube torsion spectral doc/cube.png
#
# Left, the finite elements, coloured by displacement; middle, the springs of a
# fit (or frobenius_nonlinear), coloured by stiffness; right, the error of the
# fit. Deformation x 3. On a
# machine without a screen: xvfb-run -a pvbatch ...
import pathlib
import sys
from paraview.simple import *

if len(sys.argv) != 5:
    sys.exit("usage: pvbatch scripts/picture.py FOLDER CASE FIT PICTURE.png, such as "
             "output/cube torsion spectral cube.png")
folder, case, fit, picture = sys.argv[1:]
network = fit[:-len("_nonlinear")] if fit.endswith("_nonlinear") else fit
for needed in (f"{case}_fem", f"{case}_{fit}", f"springs_{network}"):
    if not (pathlib.Path(folder) / f"{needed}.vtu").exists():
        there = sorted(file.stem for file in pathlib.Path(folder).glob("*.vtu"))
        sys.exit(f"picture.py: there is no {needed}.vtu in {folder}, but: "
                 + ", ".join(there))


def panel(source, array, title, layout, cell, representation="Surface With Edges"):
    view = CreateRenderView()
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    AssignViewToLayout(view, layout, cell)
    display = Show(source, view)
    display.Representation = representation
    ColorBy(display, ("POINTS", array))
    table = GetColorTransferFunction(array)
    table.ApplyPreset("Viridis (matplotlib)", True)
    display.RescaleTransferFunctionToDataRange(False, True)
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
    camera = view.GetActiveCamera()
    camera.SetPosition(2.4, -2.2, 1.5)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    ResetCamera(view)
    camera.Zoom(0.78)
    return view


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
