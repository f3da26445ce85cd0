#!/usr/bin/env python3
"""Reads a series of .pvd/.pvtu/.vtu files with VTK and writes it as tables.

Usage: read_vtu.py SERIES.pvd FOLDER, or FILE.vtu in place of the series

FOLDER gets `datasets.csv` (number, time, points, segments, pieces) and for each
data set `N.points.csv` (x, y, z and all fields; vectors as NAME.0, NAME.1, ...)
and `N.segments.csv` (first, second: rows of the points). Anything that VTK
warns of, and cells that are not lines of two points, end the script with exit
code 1.
"""

import csv
import os
import sys
import xml.etree.ElementTree as ElementTree

from vtkmodules.vtkCommonCore import vtkFileOutputWindow, vtkOutputWindow
from vtkmodules.vtkCommonDataModel import VTK_LINE
from vtkmodules.vtkIOXML import (
    vtkXMLPUnstructuredGridReader,
    vtkXMLUnstructuredGridReader,
)


def stop(message):
    sys.exit("read_vtu.py: " + message)


def collection(pvd):
    """Times and files of a .pvd; the files are relative to its folder."""
    if pvd.endswith(".vtu"):
        yield 0.0, pvd
        return
    root = ElementTree.parse(pvd).getroot()
    if root.tag != "VTKFile" or root.get("type") != "Collection":
        stop(pvd + " is not a VTK collection")
    folder = os.path.dirname(pvd)
    for entry in root.iter("DataSet"):
        yield float(entry.get("timestep")), os.path.join(folder, entry.get("file"))


def n_pieces(file):
    if not file.endswith(".pvtu"):
        return 1
    pieces = [piece.get("Source") for piece in ElementTree.parse(file).iter("Piece")]
    for piece in pieces:
        if not os.path.isfile(os.path.join(os.path.dirname(file), piece)):
            stop(file + " names " + piece + ", which does not exist")
    return len(pieces)


def read(file):
    if file.endswith(".pvtu"):
        reader = vtkXMLPUnstructuredGridReader()
    else:
        reader = vtkXMLUnstructuredGridReader()
    if not reader.CanReadFile(file):
        stop("VTK cannot read " + file)
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def segments(grid, file):
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)
        if cell.GetCellType() != VTK_LINE or cell.GetNumberOfPoints() != 2:
            stop("cell %d of %s is not a line of two points" % (i, file))
        yield cell.GetPointId(0), cell.GetPointId(1)


def point_table(grid):
    """Header and rows; nine digits keep a float32 exactly."""
    data = grid.GetPointData()
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    header = ["x", "y", "z"]
    for array in arrays:
        n = array.GetNumberOfComponents()
        name = array.GetName()
        header += [name] if n == 1 else ["%s.%d" % (name, d) for d in range(n)]
    rows = []
    for i in range(grid.GetNumberOfPoints()):
        values = list(grid.GetPoint(i))
        for array in arrays:
            values += array.GetTuple(i)
        rows.append(["%.9g" % value for value in values])
    return header, rows


def write(file, header, rows):
    with open(file, "w", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def main(pvd, folder):
    os.makedirs(folder, exist_ok=True)
    warnings = os.path.join(folder, "warnings.txt")
    window = vtkFileOutputWindow()
    window.SetFileName(warnings)
    window.FlushOn()
    vtkOutputWindow.SetInstance(window)

    datasets = []
    for number, (time, file) in enumerate(collection(pvd)):
        grid = read(file)
        lines = list(segments(grid, file))
        write("%s/%d.points.csv" % (folder, number), *point_table(grid))
        write("%s/%d.segments.csv" % (folder, number), ["first", "second"], lines)
        datasets.append(
            [number, repr(time), grid.GetNumberOfPoints(), len(lines), n_pieces(file)]
        )
    write(
        folder + "/datasets.csv",
        ["number", "time", "points", "segments", "pieces"],
        datasets,
    )
    if os.path.exists(warnings) and os.path.getsize(warnings) > 0:
        with open(warnings) as stream:
            stop("VTK warns: " + stream.read())


if __name__ == "__main__":
    if len(sys.argv) != 3:
        stop("usage: read_vtu.py SERIES.pvd FOLDER")
    main(*sys.argv[1:])
