#!/usr/bin/python3
"""Draws the results of a run as pictures: the lattice at given times, or curves
of history.csv.

    scripts/render.py lattice PICTURE.png RUN TIME... [--color FIELD] [options]
    scripts/render.py curves  PICTURE.png RUN COLUMN... [options]
    scripts/render.py rest    PICTURE.png FILE.vtu [--color FIELD] [options]

RUN is the output folder of a run. Struts are drawn as tubes at their current
place, rigid parts grey, plates brown, connectors as thin lines, one panel for each TIME (s,
the nearest frame is taken); all frames of the run fit into a panel, so that
pictures of single times make a film. FIELD is a field of solution.pvd; of vectors the
magnitude is shown. Curves of several runs come into one picture with --compare
RUN; --dashed RUN draws one dashed, in the colours from the first on again.
A COLUMN may be a pattern as frequency_*, or be computed: --define "angle = degrees([bar.phi]) + 30". The third kind draws
a lattice.vtu of `auxfem --check`, coloured by its height, section, ...

`cmake --install` installs it as auxfem-render. Needs python3-vtk9 of Debian's own
Python, which the first line names, and a display; without one (`xvfb` and `xauth` installed):

    xvfb-run -a scripts/render.py ...
"""

import argparse
import csv
import fnmatch
import math
import pathlib
import re
import sys
import xml.etree.ElementTree

try:
    import vtk
except ImportError:
    sys.exit("render.py: no VTK for this python3; install python3-vtk9 and "
             "call /usr/bin/python3 scripts/render.py")

TITLES = {
    "displacement": "displacement (m)",
    "velocity": "velocity (m/s)",
    "rotation": "rotation (rad)",
    "axial_force": "axial force (N)",
    "shear_force": "shear force (N)",
    "bending_moment": "bending moment (N m)",
    "shear_force_2": "shear force along axis 2 (N)",
    "shear_force_3": "shear force along axis 3 (N)",
    "torque": "torque (N m)",
    "bending_moment_2": "bending moment about axis 2 (N m)",
    "bending_moment_3": "bending moment about axis 3 (N m)",
    "strain_energy_density": "strain energy density (J/m)",
    "dissipated_energy_density": "dissipated energy density (J/m)",
    "plastic_strain": "plastic strain",
    "utilisation": "stress over yield stress",
    "intactness": "part of the forces that is left",
    "height": "height of the section (m)",
    "width": "width of the section (m)",
    "youngs_modulus": "Young's modulus (Pa)",
    "density": "density (kg/m3)",
}
COLORS = [(31, 119, 180), (214, 39, 40), (44, 160, 44), (148, 103, 189),
          (255, 127, 14), (90, 90, 90)]
DARK = (0.15, 0.15, 0.15)
RIGID = (0.35, 0.35, 0.38)
CONNECTOR = (0.10, 0.55, 0.25)
PLATE = (0.55, 0.30, 0.10)

# Where the camera is, seen from the lattice, and what is up in the picture.
VIEWS = {"front": ((0, 0, 1), (0, 1, 0)), "iso": ((2, 1.5, 3), (0, 1, 0))}

# Lattices are drawn this much larger and scaled down: software renderers do not
# smooth edges themselves. Charts would choose other ticks then.
SAMPLES = 3

# Heights (pixels) of the strips for the time below each panel and the colour
# bar below all of them.
TIME_STRIP, BAR_STRIP = 26, 76


def frames_of(series):
    """Time and file of each frame of a .pvd file."""
    root = xml.etree.ElementTree.parse(series).getroot()
    return [(float(data.get("timestep")), series.parent / data.get("file"))
            for data in root.iter("DataSet")]


def nearest_frame(series, time):
    return min(frames_of(series), key=lambda frame: abs(frame[0] - time))


def grid_of(file):
    """Content of a .vtu or .pvtu file."""
    reader = (vtk.vtkXMLPUnstructuredGridReader() if file.suffix == ".pvtu"
              else vtk.vtkXMLUnstructuredGridReader())
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


def moved_lines(file):
    """Lines of a .vtu or .pvtu file, moved by their displacement."""
    grid = grid_of(file)
    grid.GetPointData().SetActiveVectors("displacement")
    warp = vtk.vtkWarpVector()
    warp.SetInputData(grid)
    warp.Update()
    return strips_of(warp.GetOutput())


def strips_of(grid):
    """The lines of a grid, each strut in one piece."""
    surface = vtk.vtkGeometryFilter()
    surface.SetInputData(grid)
    strips = vtk.vtkStripper()
    strips.SetInputConnection(surface.GetOutputPort())
    strips.Update()
    return strips.GetOutput()


def tubes_of(lines, thickness):
    """The struts as tubes; their field `radius` times @p thickness."""
    scaled = vtk.vtkArrayCalculator()
    scaled.SetInputData(lines)
    scaled.AddScalarArrayName("radius")
    scaled.SetFunction(f"{thickness} * radius")
    scaled.SetResultArrayName("drawn_radius")
    scaled.Update()
    data = scaled.GetOutput()
    data.GetPointData().SetActiveScalars("drawn_radius")
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputData(data)
    tubes.SetVaryRadiusToVaryRadiusByAbsoluteScalar()
    tubes.SetNumberOfSides(12)
    tubes.CappingOn()
    tubes.Update()
    return tubes.GetOutput()


def usual_field(lines):
    """In space neither bending moment tells the load of a strut alone."""
    is_planar = lines.GetPointData().HasArray("bending_moment")
    return "bending_moment" if is_planar else "strain_energy_density"


def value_range(lines, field):
    """Range of a scalar, from zero or symmetric about it if it has both signs;
    of a vector's magnitude."""
    array = lines.GetPointData().GetArray(field)
    if array is None:
        names = [lines.GetPointData().GetArrayName(i)
                 for i in range(lines.GetPointData().GetNumberOfArrays())]
        sys.exit(f"render.py: there is no field {field}; there are "
                 + ", ".join(names))
    if array.GetNumberOfComponents() > 1:
        return 0.0, array.GetRange(-1)[1]
    low, high = array.GetRange(0)
    if low >= 0:
        return 0.0, high
    largest = max(-low, high)
    return -largest, largest


def color_map(low, high):
    colors = vtk.vtkColorTransferFunction()
    colors.SetColorSpaceToDiverging()
    if low < 0:
        colors.AddRGBPoint(low, 0.23, 0.30, 0.75)
        colors.AddRGBPoint(0, 0.82, 0.82, 0.82)
        colors.AddRGBPoint(high, 0.71, 0.02, 0.15)
    else:
        colors.SetColorSpaceToLab()
        colors.AddRGBPoint(low, 0.78, 0.80, 0.86)
        colors.AddRGBPoint((low + high) / 2, 0.16, 0.47, 0.72)
        colors.AddRGBPoint(high, 0.03, 0.12, 0.36)
    return colors


def tube_actor(tubes, field, colors, bounds):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(tubes)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(field)
    mapper.SetLookupTable(colors)
    mapper.SetScalarRange(*bounds)
    if tubes.GetPointData().GetArray(field).GetNumberOfComponents() > 1:
        colors.SetVectorModeToMagnitude()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.5)
    actor.GetProperty().SetDiffuse(0.5)
    return actor


def line_actor(lines, color, width):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(lines)
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetLineWidth(width * SAMPLES)
    return actor


def label(text, x, y, size):
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    actor.GetTextProperty().SetFontSize(size * SAMPLES)
    actor.GetTextProperty().SetColor(*DARK)
    actor.GetTextProperty().SetJustificationToCentered()
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(x, y)
    return actor


def color_bar(colors, n_labels=5):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colors)
    bar.SetOrientationToHorizontal()
    bar.SetNumberOfLabels(n_labels)
    bar.SetLabelFormat("%.3g")
    bar.SetPosition(0.3, 0.12)
    bar.SetWidth(0.4)
    bar.SetHeight(0.5)
    bar.UnconstrainedFontSizeOn()
    text = bar.GetLabelTextProperty()
    text.SetColor(*DARK)
    text.SetFontSize(14 * SAMPLES)
    text.ItalicOff()
    text.BoldOff()
    text.ShadowOff()
    return bar


def write_picture(window, file, samples):
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    smaller = vtk.vtkImageShrink3D()
    smaller.SetInputConnection(image.GetOutputPort())
    smaller.SetShrinkFactors(samples, samples, 1)
    smaller.AveragingOn()
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetFileName(str(file))
    writer.SetInputConnection(smaller.GetOutputPort())
    writer.Write()


def renderer(window, left, bottom, right, top):
    """An empty part of the window, given by fractions of its sides."""
    part = vtk.vtkRenderer()
    part.SetBackground(1, 1, 1)
    part.SetViewport(left, bottom, right, top)
    window.AddRenderer(part)
    return part


def unit(vector):
    length = math.hypot(*vector)
    return [component / length for component in vector]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]]


def size_in(view, box):
    """Width and height of the box in the picture."""
    direction, up = VIEWS[view]
    to_right = unit(cross(up, direction))
    upwards = unit(cross(direction, to_right))
    return [sum(abs(axis[d]) * box.GetLength(d) for d in range(3))
            for axis in (to_right, upwards)]


def look_at(panel, box, view):
    centre = [0.0, 0.0, 0.0]
    box.GetCenter(centre)
    direction, up = VIEWS[view]
    away = 10 * box.GetDiagonalLength()
    camera = panel.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(centre)
    camera.SetPosition([c + away * d for c, d in zip(centre, unit(direction))])
    camera.SetViewUp(up)
    camera.SetParallelScale(size_in(view, box)[1] / 2)
    panel.ResetCameraClippingRange()


def box_around(lines):
    box = vtk.vtkBoundingBox()
    for data in lines:
        box.AddBounds(data.GetBounds())
    box.Inflate(0.03 * box.GetDiagonalLength())
    return box


def color_bounds(lines, arguments):
    ranges = [value_range(data, arguments.color) for data in lines]
    largest = arguments.largest or max(high for _, high in ranges)
    return (-largest if min(low for low, _ in ranges) < 0 else 0.0), largest


def box_of_all_frames(run):
    """Around struts, rigid parts and plates of the run at all times."""
    return box_around([moved_lines(file)
                       for name in ("solution.pvd", "rigid_parts.pvd",
                                    "plates.pvd")
                       if (run / name).exists()
                       for _, file in frames_of(run / name)])


def lines_at(run, name, times):
    """Moved lines of a series of the run at each time; None without it."""
    series = run / (name + ".pvd")
    if not series.exists():
        return None
    return [moved_lines(nearest_frame(series, time)[1]) for time in times]


def frame_times(run, times):
    for name in ("solution.pvd", "rigid_parts.pvd"):
        if (run / name).exists():
            return [nearest_frame(run / name, time)[0] for time in times]
    sys.exit(f"render.py: {run} has neither solution.pvd nor rigid_parts.pvd")


def draw_lattice(arguments):
    run = pathlib.Path(arguments.run)
    times = frame_times(run, arguments.values)
    struts = lines_at(run, "solution", times)
    thin_lines = [(lines_at(run, "rigid_parts", times), RIGID, 2.2),
                  (lines_at(run, "connectors", times), CONNECTOR, 1.5),
                  (lines_at(run, "plates", times), PLATE, 2.2)]
    if struts:
        arguments.color = arguments.color or usual_field(struts[0])
        bounds = color_bounds(struts, arguments)
        colors = color_map(*bounds)
    box = box_of_all_frames(run)

    n_panels = len(times)
    width, height = size_in(arguments.view, box)
    panel_height = round(arguments.width * height / (n_panels * width))
    bar_height = BAR_STRIP if struts else 0
    total = panel_height + TIME_STRIP + bar_height
    # Films need even heights.
    total += total % 2
    bar_top, strip_top = bar_height / total, (bar_height + TIME_STRIP) / total
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(SAMPLES * arguments.width, SAMPLES * total)
    for i, time in enumerate(times):
        left, right = i / n_panels, (i + 1) / n_panels
        panel = renderer(window, left, strip_top, right, 1)
        if struts:
            panel.AddActor(tube_actor(tubes_of(struts[i], arguments.thickness),
                                      arguments.color, colors, bounds))
        for lines, color, width in thin_lines:
            if lines:
                panel.AddActor(line_actor(lines[i], color, width))
        look_at(panel, box, arguments.view)
        strip = renderer(window, left, bar_top, right, strip_top)
        strip.AddActor2D(label(f"t = {time:g} s", 0.5, 0.2, 14))
    if struts:
        bar = renderer(window, 0, 0, 1, bar_top)
        # A bar's own title would overlap its numbers.
        bar.AddActor2D(label(TITLES.get(arguments.color, arguments.color),
                             0.5, 0.72, 14))
        bar.AddActor2D(color_bar(colors))
    write_picture(window, arguments.picture, SAMPLES)


def lines_with(grid, field):
    """Lines of the grid whose @p field is at least zero."""
    chosen = vtk.vtkThreshold()
    chosen.SetInputData(grid)
    chosen.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS,
                                  field)
    chosen.SetUpperThreshold(0)
    chosen.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_UPPER)
    chosen.Update()
    return strips_of(chosen.GetOutput())


def draw_rest(arguments):
    grid = grid_of(pathlib.Path(arguments.run))
    struts = lines_with(grid, "strut")
    connectors = lines_with(grid, "connectors")
    field = arguments.color
    low, high = struts.GetPointData().GetArray(field or "radius").GetRange(0)
    colors = color_map(low, high if high > low else low + 1)
    box = box_around([struts])
    width, height = size_in(arguments.view, box)
    bar_height = BAR_STRIP if field else 0
    total = round(arguments.width * height / width) + bar_height
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(SAMPLES * arguments.width, SAMPLES * total)
    panel = renderer(window, 0, bar_height / total, 1, 1)
    tubes = tube_actor(tubes_of(struts, arguments.thickness), field or "radius",
                       colors, (low, high))
    if not field:
        tubes.GetMapper().ScalarVisibilityOff()
        tubes.GetProperty().SetColor(0.16, 0.47, 0.72)
    panel.AddActor(tubes)
    panel.AddActor(line_actor(connectors, CONNECTOR, 1.5))
    look_at(panel, box, arguments.view)
    if field:
        bar = renderer(window, 0, 0, 1, bar_height / total)
        bar.AddActor2D(label(TITLES.get(field, field), 0.5, 0.72, 14))
        bar.AddActor2D(color_bar(colors, 3))
    write_picture(window, arguments.picture, SAMPLES)


def defined_columns(definitions):
    """Formula of each column of --define, by its name."""
    formulas = {}
    for definition in definitions:
        name, _, formula = definition.partition("=")
        formulas[name.strip()] = formula.strip()
    return formulas


def evaluate(formula, row):
    """A formula of mathematics in which [NAME] is a column of the row."""
    numbers = {}

    def number_name(match):
        numbers[f"column_{len(numbers)}"] = float(row[match.group(1)])
        return f"column_{len(numbers) - 1}"

    return eval(re.sub(r"\[([^]]*)\]", number_name, formula),
                {"__builtins__": {}}, {**vars(math), **numbers})


def named_columns(run, table, patterns):
    """The columns that fit patterns as frequency_*, others as they are."""
    with open(pathlib.Path(run) / (table + ".csv"), encoding="utf-8") as stream:
        names = next(csv.reader(stream))
    return [name for pattern in patterns
            for name in (fnmatch.filter(names, pattern) or [pattern])]


def read_history(run, table, columns, formulas):
    file = pathlib.Path(run) / (table + ".csv")
    with open(file, encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    try:
        return {column: [evaluate(formulas.get(column, f"[{column}]"), row)
                         for row in rows] for column in columns}
    except KeyError as missing:
        sys.exit(f"render.py: {file} has no column {missing}; it has "
                 + ", ".join(rows[0]))


def unit_of(run, table, column):
    with open(pathlib.Path(run) / (table + ".units.csv"),
              encoding="utf-8") as stream:
        for row in csv.reader(stream):
            if row[0] == column:
                return row[1]
    return ""


def curve_table(abscissa, values, name):
    table = vtk.vtkTable()
    for title, numbers in (("x", abscissa), (name, values)):
        array = vtk.vtkDoubleArray()
        array.SetName(title)
        array.SetNumberOfValues(len(numbers))
        for i, value in enumerate(numbers):
            array.SetValue(i, value)
        table.AddColumn(array)
    return table


def label_axes(chart, titles):
    for place, title in titles.items():
        axis = chart.GetAxis(place)
        axis.SetTitle(title)
        axis.GetTitleProperties().SetFontSize(15)
        axis.GetTitleProperties().BoldOff()
        axis.GetLabelProperties().SetFontSize(13)
        axis.GetGridPen().SetColor(225, 225, 225, 255)


def place_legend(chart, place):
    chart.SetShowLegend(True)
    legend = chart.GetLegend()
    legend.GetLabelProperties().SetFontSize(14)
    side, height = place.split("-") if "-" in place else ("right", place)
    legend.SetHorizontalAlignment({"left": vtk.vtkChartLegend.LEFT,
                                   "right": vtk.vtkChartLegend.RIGHT}[side])
    legend.SetVerticalAlignment({"top": vtk.vtkChartLegend.TOP,
                                 "centre": vtk.vtkChartLegend.CENTER,
                                 "bottom": vtk.vtkChartLegend.BOTTOM}[height])


def curve_name(run, column, arguments, place):
    """The label of a curve: the given name of its run, or run and column."""
    if place < len(arguments.name):
        run_name = arguments.name[place]
    elif arguments.compare or arguments.dashed:
        run_name = pathlib.Path(run).name
    else:
        return column
    return run_name if arguments.panels else f"{run_name}: {column}"


def add_plots(chart, columns, arguments):
    solid = [arguments.run] + arguments.compare
    formulas = defined_columns(arguments.define)
    for place, run in enumerate(solid + arguments.dashed):
        is_dashed = place >= len(solid)
        history = read_history(run, arguments.table, [arguments.over] + columns,
                               formulas)
        for i, column in enumerate(columns):
            plot = chart.AddPlot(vtk.vtkChart.LINE)
            plot.SetInputData(
                curve_table(history[arguments.over], history[column],
                            curve_name(run, column, arguments, place)), 0, 1)
            color = (place - is_dashed * len(solid)) * len(columns) + i
            plot.SetColor(*COLORS[color % len(COLORS)], 255)
            plot.SetWidth(2)
            if is_dashed:
                plot.GetPen().SetLineType(vtk.vtkPen.DASH_LINE)


def draw_curves(arguments):
    arguments.values = named_columns(arguments.run, arguments.table,
                                     arguments.values)
    panels = ([[column] for column in arguments.values] if arguments.panels
              else [arguments.values])
    matrix = vtk.vtkChartMatrix()
    matrix.SetSize(vtk.vtkVector2i(len(panels), 1))
    matrix.SetGutterX(85)
    matrix.SetBorders(70, 55, 20, 15)
    for i, columns in enumerate(panels):
        chart = matrix.GetChart(vtk.vtkVector2i(i, 0))
        add_plots(chart, columns, arguments)
        units = {unit_of(arguments.run, arguments.table, column)
                 for column in columns}
        title = " / ".join(sorted(units))
        if arguments.panels:
            title = f"{columns[0]} ({title})" if title else columns[0]
        unit = unit_of(arguments.run, arguments.table, arguments.over)
        label_axes(chart, {
            vtk.vtkAxis.BOTTOM:
                f"{arguments.over} ({unit})" if unit else arguments.over,
            vtk.vtkAxis.LEFT: title})
        if i == 0:
            place_legend(chart, arguments.legend)

    view = vtk.vtkContextView()
    view.GetRenderer().SetBackground(1, 1, 1)
    view.GetScene().AddItem(matrix)
    window = view.GetRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(arguments.width, round(0.45 * arguments.width))
    write_picture(window, arguments.picture, 1)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    kinds = parser.add_subparsers(dest="kind", required=True)
    lattice = kinds.add_parser("lattice", help="the lattice at given times")
    curves = kinds.add_parser("curves", help="columns of history.csv")
    rest = kinds.add_parser("rest", help="the lattice as it is made")
    for kind in (lattice, curves, rest):
        kind.add_argument("picture", help="file to write (PNG)")
        kind.add_argument("run", help="output folder of a run" if kind != rest
                          else "lattice.vtu of auxfem --check")
        kind.add_argument("--width", type=int, default=900,
                          help="of the picture, in pixels")
    lattice.add_argument("values", metavar="time", nargs="+", type=float)
    lattice.add_argument("--color", metavar="FIELD",
                         help="default: bending_moment, in space "
                              "strain_energy_density")
    rest.add_argument("--color", metavar="FIELD", help="default: one colour")
    for kind in (lattice, rest):
        kind.add_argument("--view", default="front", choices=sorted(VIEWS),
                          help="along z, or obliquely for lattices in space")
        kind.add_argument("--thickness", type=float, default=1, metavar="FACTOR",
                          help="draw struts this much thicker than they are")
    lattice.add_argument("--largest", type=float, metavar="VALUE",
                         help="end of the colour scale; larger values look "
                              "like it")
    curves.add_argument("values", metavar="column", nargs="+")
    curves.add_argument("--table", default="history", metavar="NAME",
                        help="of NAME.csv and NAME.units.csv")
    curves.add_argument("--over", default="time", metavar="COLUMN",
                        help="what is plotted to the right")
    curves.add_argument("--compare", action="append", default=[],
                        metavar="RUN", help="another run in the same picture")
    curves.add_argument("--dashed", action="append", default=[], metavar="RUN",
                        help="another run, dashed")
    curves.add_argument("--name", action="append", default=[],
                        help="of a run in the legend; one for each run, solid "
                             "ones first")
    curves.add_argument("--define", action="append", default=[],
                        metavar="NAME=FORMULA",
                        help="a column computed from others, each in brackets")
    curves.add_argument("--panels", action="store_true",
                        help="a panel for each column")
    curves.add_argument("--legend", default="top",
                        choices=["top", "centre", "bottom", "left-top",
                                 "left-centre", "left-bottom"],
                        help="its place, on the right unless said")
    arguments = parser.parse_args()
    draw = {"lattice": draw_lattice, "curves": draw_curves, "rest": draw_rest}
    draw[arguments.kind](arguments)


if __name__ == "__main__":
    main()
