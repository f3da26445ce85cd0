"""Files of a run: time series for ParaView and tables."""

import csv
import fnmatch
import math
import pathlib
import re
import sys
import xml.etree.ElementTree

import vtk


def stop(message):
    """Ends the program with a message and the exit code for wrong input."""
    print("auxfem-view: " + message, file=sys.stderr)
    sys.exit(1)


class Series:
    """A .pvd file: the times (s) of its frames, and their files."""

    def __init__(self, file):
        self.file = file
        try:
            root = xml.etree.ElementTree.parse(file).getroot()
        except (OSError, xml.etree.ElementTree.ParseError) as error:
            stop(f"{file} cannot be read: {error}")
        self.frames = [(float(data.get("timestep")), file.parent / data.get("file"))
                       for data in root.iter("DataSet")]
        if not self.frames:
            stop(f"{file} lists no frame")

    def times(self):
        return [time for time, _ in self.frames]

    def nearest(self, time):
        """Time and file of the frame nearest to a time, which may be infinite."""
        time = min(time, self.frames[-1][0])
        return min(self.frames, key=lambda frame: abs(frame[0] - time))


def folder_of(run):
    """The output folder of a run."""
    folder = pathlib.Path(run)
    if not folder.is_dir():
        stop(f"there is no folder {folder}; give the output folder of a run")
    return folder


def series_of(folder, name):
    """The series NAME.pvd of a folder; None without it."""
    file = folder / (name + ".pvd")
    return Series(file) if file.exists() else None


def read_grid(file):
    """Content of a .vtu or .pvtu file."""
    reader = (vtk.vtkXMLPUnstructuredGridReader() if file.suffix == ".pvtu"
              else vtk.vtkXMLUnstructuredGridReader())
    if not file.exists():
        stop(f"there is no file {file}")
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


class Table:
    """NAME.csv of a run, with the units in NAME.units.csv."""

    def __init__(self, run, name):
        self.file = folder_of(run) / (name + ".csv")
        if not self.file.exists():
            stop(f"there is no table {self.file}")
        with open(self.file, encoding="utf-8", newline="") as stream:
            rows = list(csv.reader(stream))
        self.names, self.rows = rows[0], rows[1:]
        self.units = {}
        reference = self.file.with_name(name + ".units.csv")
        if reference.exists():
            with open(reference, encoding="utf-8", newline="") as stream:
                self.units = {row[0]: row[1] for row in csv.reader(stream)}

    def matching(self, patterns):
        """The columns that fit patterns such as frequency_*; others as they are."""
        return [name for pattern in patterns
                for name in (fnmatch.filter(self.names, pattern) or [pattern])]

    def column(self, name, formulas):
        """Numbers of a column, or of the formula with its name."""
        formula = formulas.get(name, f"[{name}]")
        variables = {}

        def number_name(match):
            if match.group(1) not in self.names:
                stop(f"{self.file} has no column {match.group(1)}; it has "
                     + ", ".join(self.names))
            return variables.setdefault(match.group(1), f"column_{len(variables)}")

        code = compile(re.sub(r"\[([^]]*)\]", number_name, formula), name, "eval")
        places = {variable: self.names.index(column)
                  for column, variable in variables.items()}
        return [eval(code, {"__builtins__": {}},
                     {**vars(math),
                      **{variable: number_in(row[place])
                         for variable, place in places.items()}})
                for row in self.rows]


def number_in(text):
    try:
        return float(text)
    except ValueError:
        return math.nan
