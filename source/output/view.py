"""Shows the results in the folder of this file in ParaView: struts as tubes of their
own thickness, moved, coloured over all times; connectors, rigid parts and plates.

    paraview --script=view.py          or in ParaView: View, Python Shell, Run Script
    pvpython view.py PICTURE.png [TIME]    a picture without a window, of the last frame

Written by auxfem; a new run replaces it.
"""

import glob
import os
import sys

import paraview
from paraview.simple import *

# Colour of the struts: the first of these fields that the run has.
FIELDS = ["von_mises_stress", "bending_moment", "strain_energy_density"]
FACTOR = 1  # of the drawn displacement

# ParaView's menu does not say where a script lies.
FOLDER = (os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals()
          else FOLDER_OF_THE_RUN)


def prefix():
    """Empty for the motion of a run; of a run with modes alone the first mode."""
    found = sorted(glob.glob(os.path.join(FOLDER, "*solution.pvd"))
                   + glob.glob(os.path.join(FOLDER, "*rigid_parts.pvd")),
                   key=lambda file: (len(os.path.basename(file)), file))
    if not found:
        sys.exit("view.py: there are no results for ParaView in " + FOLDER)
    name = os.path.basename(found[0])
    for series in ("solution.pvd", "rigid_parts.pvd"):
        if name.endswith(series):
            return name[:-len(series)]


def moved_lines(name):
    """The moved lines of the series NAME.pvd, or None."""
    file = os.path.join(FOLDER, prefix() + name + ".pvd")
    if not os.path.exists(file):
        return None
    reader = PVDReader(registrationName=name, FileName=file)
    moved = WarpByVector(registrationName=name + " moved", Input=reader)
    moved.Vectors = ["POINTS", "displacement"]
    moved.ScaleFactor = FACTOR
    return moved


def show_lines(name, color, width, view):
    lines = moved_lines(name)
    if lines is None:
        return
    shown = Show(lines, view)
    shown.ColorArrayName = [None, ""]
    shown.AmbientColor = shown.DiffuseColor = color
    shown.LineWidth = width


def show_struts(view):
    moved = moved_lines("solution")
    if moved is None:
        return
    # The tube filter takes polygonal data only.
    lines = ExtractSurface(registrationName="strut lines", Input=moved)
    tubes = Tube(registrationName="struts", Input=lines)
    tubes.Scalars = ["POINTS", "radius"]
    tubes.VaryRadius = "By Absolute Scalar"
    tubes.Capping = 1
    shown = Show(tubes, view)
    field = [name for name in FIELDS if name in tubes.PointData.keys()][0]
    ColorBy(shown, ("POINTS", field))
    shown.RescaleTransferFunctionToDataRangeOverTime()
    colors = GetColorTransferFunction(field)
    low, high = colors.RGBPoints[0], colors.RGBPoints[-4]
    largest = max(-low, high) or 1
    colors.ApplyPreset("Cool to Warm" if low < 0 else "Viridis (matplotlib)", True)
    colors.RescaleTransferFunction(-largest if low < 0 else 0, largest)
    shown.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(colors, view)
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Lower Center"
    bar.TitleFontSize = bar.LabelFontSize = 14


def is_plane(view):
    """Whether all points lie in a plane z = constant."""
    return all(source.GetDataInformation().GetBounds()[4]
               == source.GetDataInformation().GetBounds()[5]
               for (name, _), source in GetSources().items()
               if name.endswith(" moved"))


def main():
    view = GetActiveViewOrCreate("RenderView")
    show_struts(view)
    show_lines("rigid_parts", [0.35, 0.35, 0.38], 3, view)
    show_lines("connectors", [0.10, 0.55, 0.25], 2, view)
    show_lines("plates", [0.55, 0.30, 0.10], 3, view)
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToLast()
    if len(sys.argv) > 2:
        scene.AnimationTime = float(sys.argv[2])
    Render(view)
    if is_plane(view):
        view.InteractionMode = "2D"
        view.ResetActiveCameraToNegativeZ()
    else:
        view.ApplyIsometricView()
    ResetCamera(view)
    Render(view)
    if len(sys.argv) > 1 and sys.argv[1].endswith(".png"):
        view.ViewSize = [1200, 900]
        ResetCamera(view)
        SaveScreenshot(sys.argv[1], view, OverrideColorPalette="WhiteBackground")


main()
