"""Parts of pictures: tubes, springs, plates, colours, cameras, panels."""

import math

import vtk

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

# Turns of a drawn spring, and its radius over the length of the longest one at rest.
TURNS, SPRING_RADIUS = 5, 0.06


def moved(grid, factor=1):
    """A grid moved by its displacement times a factor."""
    grid.GetPointData().SetActiveVectors("displacement")
    warp = vtk.vtkWarpVector()
    warp.SetInputData(grid)
    warp.SetScaleFactor(factor)
    warp.Update()
    return warp.GetOutput()


def strips_of(grid):
    """The lines of a grid, each strut in one piece."""
    surface = vtk.vtkGeometryFilter()
    surface.SetInputData(grid)
    strips = vtk.vtkStripper()
    strips.SetInputConnection(surface.GetOutputPort())
    strips.Update()
    return strips.GetOutput()


def tubes_of(lines, thickness):
    """The struts as tubes; their field `radius` times a thickness factor."""
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


def springs_of(grid, radius):
    """Each line of a grid of connectors as a coil with straight ends, whose
    number of turns stays while it is stretched."""
    points, lines = vtk.vtkPoints(), vtk.vtkCellArray()
    steps = 12 * TURNS
    for i in range(grid.GetNumberOfCells()):
        ends = grid.GetCell(i).GetPoints()
        begin = ends.GetPoint(0)
        end = ends.GetPoint(ends.GetNumberOfPoints() - 1)
        axis = [b - a for a, b in zip(begin, end)]
        length = math.hypot(*axis)
        if length == 0:
            continue
        side = unit(cross(axis, (0, 0, 1) if abs(axis[2]) < 0.9 * length
                          else (1, 0, 0)))
        other = unit(cross(axis, side))
        lines.InsertNextCell(steps + 3)
        for k in range(-1, steps + 2):
            # A fifth of the length at each end is straight.
            part = 0 if k < 0 else 1 if k > steps else 0.2 + 0.6 * k / steps
            angle = 2 * math.pi * TURNS * k / steps
            a = radius * math.sin(angle) if 0 <= k <= steps else 0
            b = radius * (math.cos(angle) - 1) if 0 <= k <= steps else 0
            lines.InsertCellPoint(points.InsertNextPoint(
                *[begin[d] + part * axis[d] + a * side[d] + b * other[d]
                  for d in range(3)]))
    coils = vtk.vtkPolyData()
    coils.SetPoints(points)
    coils.SetLines(lines)
    return coils


def longest_line(grid):
    """Length of the longest line of a grid."""
    longest = 0
    for i in range(grid.GetNumberOfCells()):
        longest = max(longest, grid.GetCell(i).GetLength2())
    return math.sqrt(longest)


def value_range(data, field):
    """Range of a scalar, from zero or symmetric about it if it has both signs;
    of a vector's magnitude. None without such a field."""
    array = data.GetPointData().GetArray(field)
    if array is None:
        return None
    if array.GetNumberOfComponents() > 1:
        return 0.0, array.GetRange(-1)[1]
    low, high = array.GetRange(0)
    if low >= 0:
        return 0.0, high
    largest = max(-low, high)
    return -largest, largest


def field_names(data):
    return [data.GetPointData().GetArrayName(i)
            for i in range(data.GetPointData().GetNumberOfArrays())]


def color_map(low, high):
    """Diverging colours about zero, sequential ones for positive fields."""
    colors = vtk.vtkColorTransferFunction()
    if low < 0:
        colors.SetColorSpaceToDiverging()
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


def plain_actor(data, color, width=1):
    """Data of one colour; lines have a width in pixels."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
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


def new_window(width, height):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(SAMPLES * width, SAMPLES * height)
    return window


def renderer(window, left, bottom, right, top):
    """An empty part of the window, given by fractions of its sides."""
    part = vtk.vtkRenderer()
    part.SetBackground(1, 1, 1)
    part.SetViewport(left, bottom, right, top)
    window.AddRenderer(part)
    return part


def png_of(window, samples):
    """The picture of a window as the bytes of a PNG file."""
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.ShouldRerenderOff()
    smaller = vtk.vtkImageShrink3D()
    smaller.SetInputConnection(image.GetOutputPort())
    smaller.SetShrinkFactors(samples, samples, 1)
    smaller.AveragingOn()
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetWriteToMemory(True)
    writer.SetInputConnection(smaller.GetOutputPort())
    writer.Write()
    return bytes(memoryview(writer.GetResult()))


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


def box_around(grids):
    box = vtk.vtkBoundingBox()
    for data in grids:
        box.AddBounds(data.GetBounds())
    box.Inflate(0.03 * box.GetDiagonalLength())
    return box
