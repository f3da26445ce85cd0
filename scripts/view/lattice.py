"""Pictures of the lattice of a run: at times, of all frames, of modes."""

import vtk

from .drawing import (CONNECTOR, PLATE, RIGID, SAMPLES, SPRING_RADIUS, box_around,
                      color_bar, color_map, field_names, label, longest_line,
                      look_at, moved, new_window, plain_actor, png_of, renderer,
                      size_in, springs_of, strips_of, tube_actor, tubes_of,
                      value_range)
from .files import read_grid, series_of, stop

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
    "axial_stress": "axial stress (Pa)",
    "bending_stress": "bending stress (Pa)",
    "shear_stress": "shear stress (Pa)",
    "torsion_stress": "torsion stress (Pa)",
    "von_mises_stress": "von Mises stress (Pa)",
    "fibre_strain": "largest fibre strain",
    "height": "height of the section (m)",
    "width": "width of the section (m)",
    "youngs_modulus": "Young's modulus (Pa)",
    "density": "density (kg/m3)",
}

# Heights (pixels) of the strips for the text below each panel and the colour bar
# below all of them.
TEXT_STRIP, BAR_STRIP = 26, 76

# Parts of a frame: what they are called in the folder of a run.
PARTS = ("solution", "rigid_parts", "connectors", "plates")


def usual_field(grid):
    """In space neither bending moment tells the load of a strut alone."""
    names = field_names(grid)
    for name in ("von_mises_stress", "bending_moment", "strain_energy_density"):
        if name in names:
            return name
    return "displacement"


class Frame:
    """Grids of one panel, not yet moved, by the names of PARTS."""

    def __init__(self, text, grids, factor=1):
        self.text = text
        self.grids = {name: moved(grid, factor) for name, grid in grids.items()}

    def struts(self):
        return self.grids.get("solution")


def frames_at(folder, times, prefix=""):
    """A frame for each time, the nearest one of the run; all frames if there are
    no times."""
    series = {name: series_of(folder, prefix + name) for name in PARTS}
    series = {name: found for name, found in series.items() if found}
    first = series.get("solution") or series.get("rigid_parts")
    if first is None:
        stop(f"{folder} has neither {prefix}solution.pvd nor {prefix}rigid_parts.pvd; "
             "set Output/Graphics = true, or give another folder")
    for time in (times or first.times()):
        time = first.nearest(time)[0]
        yield Frame(f"t = {time:.4g} s",
                    {name: read_grid(found.nearest(time)[1])
                     for name, found in series.items()})


class Extent:
    """Box and range of colours that fit all frames."""

    def __init__(self, frames, arguments):
        self.field, self.low, self.high, self.spring = arguments.color, 0, 0, 0
        bounds = []
        for frame in frames:
            bounds += [grid for name, grid in frame.grids.items()
                       if name != "connectors"]
            if "connectors" in frame.grids:
                self.spring = max(self.spring,
                                  longest_line(frame.grids["connectors"]))
            if frame.struts():
                self.add_colors(frame.struts())
        self.box = box_around(bounds)
        if arguments.largest:
            self.high = arguments.largest
            self.low = -self.high if self.low < 0 else 0
        if self.high <= self.low:
            self.high = self.low + 1

    def add_colors(self, grid):
        self.field = self.field or usual_field(grid)
        found = value_range(grid, self.field)
        if found is None:
            stop(f"there is no field {self.field}; there are "
                 + ", ".join(field_names(grid)))
        self.low, self.high = min(self.low, found[0]), max(self.high, found[1])
        if self.low < 0:
            self.high = max(self.high, -self.low)
            self.low = -self.high


def plate_actors(grid):
    """Closed outlines filled: discs in the plane, squares in space."""
    lines = strips_of(grid)
    actors = [plain_actor(lines, PLATE, 2.2)]
    filled, faces = vtk.vtkPolyData(), vtk.vtkCellArray()
    flat = grid.GetBounds()[4] == grid.GetBounds()[5]
    square = 5
    for i in range(lines.GetNumberOfCells()):
        points = lines.GetCell(i).GetPointIds()
        n = points.GetNumberOfIds()
        first, last = points.GetId(0), points.GetId(n - 1)
        closed = lines.GetPoint(first) == lines.GetPoint(last)
        if n > 3 and closed and (flat or n == square):
            faces.InsertNextCell(n - 1)
            for k in range(n - 1):
                faces.InsertCellPoint(points.GetId(k))
    if faces.GetNumberOfCells():
        filled.SetPoints(lines.GetPoints())
        filled.SetPolys(faces)
        actors.append(plain_actor(filled, PLATE))
        actors[-1].GetProperty().SetOpacity(0.4)
    return actors


def add_parts(panel, frame, extent, colors, thickness):
    if frame.struts():
        panel.AddActor(tube_actor(tubes_of(strips_of(frame.struts()), thickness),
                                  extent.field, colors, (extent.low, extent.high)))
    if "rigid_parts" in frame.grids:
        panel.AddActor(plain_actor(strips_of(frame.grids["rigid_parts"]), RIGID,
                                   2.2))
    if "connectors" in frame.grids:
        panel.AddActor(plain_actor(
            springs_of(frame.grids["connectors"], SPRING_RADIUS * extent.spring),
            CONNECTOR, 1.2))
    if "plates" in frame.grids:
        for actor in plate_actors(frame.grids["plates"]):
            panel.AddActor(actor)


class Stage:
    """A window with a panel for each of so many frames above a bar of colours,
    drawn again and again: a new window would take a second."""

    def __init__(self, n_panels, extent, has_struts, arguments):
        self.extent, self.arguments = extent, arguments
        self.colors = color_map(extent.low, extent.high)
        width, height = size_in(arguments.view, extent.box)
        panel_height = round(arguments.width * height / (n_panels * width))
        bar_height = BAR_STRIP if has_struts else 0
        total = panel_height + TEXT_STRIP + bar_height
        total += total % 2  # films need even heights
        bar_top = bar_height / total
        strip_top = (bar_height + TEXT_STRIP) / total
        self.window = new_window(arguments.width, total)
        self.panels, self.strips = [], []
        for i in range(n_panels):
            left, right = i / n_panels, (i + 1) / n_panels
            self.panels.append(renderer(self.window, left, strip_top, right, 1))
            self.strips.append(renderer(self.window, left, bar_top, right,
                                        strip_top))
        if has_struts:
            bar = renderer(self.window, 0, 0, 1, bar_top)
            # A bar's own title would overlap its numbers.
            bar.AddActor2D(label(TITLES.get(extent.field, extent.field), 0.5, 0.72,
                                 14))
            bar.AddActor2D(color_bar(self.colors))

    def picture_of(self, frames):
        """PNG of the frames."""
        for frame, panel, strip in zip(frames, self.panels, self.strips):
            panel.RemoveAllViewProps()
            strip.RemoveAllViewProps()
            add_parts(panel, frame, self.extent, self.colors,
                      self.arguments.thickness)
            look_at(panel, self.extent.box, self.arguments.view)
            strip.AddActor2D(label(frame.text, 0.5, 0.2, 14))
        return png_of(self.window, SAMPLES)


def picture_of(frames, extent, arguments):
    """PNG of the frames side by side."""
    has_struts = any(frame.struts() for frame in frames)
    return Stage(len(frames), extent, has_struts, arguments).picture_of(frames)


def pictures_at(folder, times, arguments):
    """The picture of some frames, with the box of the whole run, so that
    pictures of single times make a film."""
    extent = Extent(frames_at(folder, []), arguments)
    return picture_of(list(frames_at(folder, times)), extent, arguments)


def all_pictures(folder, arguments):
    """The pictures of all frames, one after the other."""
    extent, stage = Extent(frames_at(folder, []), arguments), None
    for frame in frames_at(folder, []):
        stage = stage or Stage(1, extent, bool(frame.struts()), arguments)
        yield stage.picture_of([frame])


def mode_numbers(folder):
    """Numbers of the modes that a run has drawn."""
    numbers = []
    for name in ("solution", "rigid_parts"):
        for file in folder.glob(f"mode_*_{name}.pvd"):
            numbers.append(file.name[len("mode_"):-len(f"_{name}.pvd")])
    return sorted(set(numbers), key=int)


def picture_of_modes(folder, wanted, arguments):
    """A panel for each mode, at its largest amplitude."""
    numbers = mode_numbers(folder)
    chosen = [n for n in numbers if int(n) in wanted] if wanted else numbers[:4]
    if not chosen:
        stop(f"{folder} has no such mode; it has "
             + (", ".join(str(int(n)) for n in numbers) or "none"))
    frames = []
    for number in chosen:
        along = list(frames_at(folder, [], f"mode_{number}_"))
        # The frames go once through a period; the first is the largest.
        along[0].text = f"mode {int(number)}"
        frames.append(along[0])
    return picture_of(frames, Extent(frames, arguments), arguments)


def lines_with(grid, field):
    """Lines of the grid whose field is at least zero."""
    chosen = vtk.vtkThreshold()
    chosen.SetInputData(grid)
    chosen.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS,
                                  field)
    chosen.SetUpperThreshold(0)
    chosen.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_UPPER)
    chosen.Update()
    return chosen.GetOutput()


def picture_at_rest(file, arguments):
    """The lattice.vtu of `auxfem --check`."""
    grid = read_grid(file)
    struts = strips_of(lines_with(grid, "strut"))
    connectors = lines_with(grid, "connectors")
    field = arguments.color or "radius"
    if field not in field_names(struts):
        stop(f"there is no field {field}; there are "
             + ", ".join(field_names(struts)))
    low, high = struts.GetPointData().GetArray(field).GetRange(0)
    colors = color_map(low, high if high > low else low + 1)
    box = box_around([struts])
    width, height = size_in(arguments.view, box)
    bar_height = BAR_STRIP if arguments.color else 0
    total = round(arguments.width * height / width) + bar_height
    window = new_window(arguments.width, total)
    panel = renderer(window, 0, bar_height / total, 1, 1)
    tubes = tube_actor(tubes_of(struts, arguments.thickness), field, colors,
                       (low, high))
    if not arguments.color:
        tubes.GetMapper().ScalarVisibilityOff()
        tubes.GetProperty().SetColor(0.16, 0.47, 0.72)
    panel.AddActor(tubes)
    panel.AddActor(plain_actor(
        springs_of(connectors, SPRING_RADIUS * longest_line(connectors)), CONNECTOR,
        1.2))
    look_at(panel, box, arguments.view)
    if arguments.color:
        bar = renderer(window, 0, 0, 1, bar_height / total)
        bar.AddActor2D(label(TITLES.get(field, field), 0.5, 0.72, 14))
        bar.AddActor2D(color_bar(colors, 3))
    return png_of(window, SAMPLES)
