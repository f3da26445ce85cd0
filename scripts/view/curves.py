"""Curves of the tables of runs."""

import pathlib

import vtk

from .drawing import COLORS, png_of
from .files import Table, stop


def formulas_of(definitions):
    """Formula of each column of --define, by its name."""
    formulas = {}
    for definition in definitions:
        name, equals, formula = definition.partition("=")
        if not equals:
            stop(f"--define {definition}: write NAME=FORMULA, with columns in "
                 "brackets")
        formulas[name.strip()] = formula.strip()
    return formulas


def usual_columns(table):
    """Displacements of probes and supports, else the columns after the first."""
    motions = [name for name in table.names[1:] if table.units.get(name) == "m"]
    return (motions or table.names[1:])[:6]


def curve_data(abscissa, values, name):
    data = vtk.vtkTable()
    for title, numbers in (("x", abscissa), (name, values)):
        array = vtk.vtkDoubleArray()
        array.SetName(title)
        array.SetNumberOfValues(len(numbers))
        for i, value in enumerate(numbers):
            array.SetValue(i, value)
        data.AddColumn(array)
    return data


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


def add_plots(chart, columns, over, arguments):
    solid = [arguments.run] + arguments.compare
    formulas = formulas_of(arguments.define)
    for place, run in enumerate(solid + arguments.dashed):
        is_dashed = place >= len(solid)
        table = Table(run, arguments.table)
        abscissa = table.column(over, formulas)
        for i, column in enumerate(columns):
            plot = chart.AddPlot(vtk.vtkChart.LINE)
            plot.SetInputData(
                curve_data(abscissa, table.column(column, formulas),
                           curve_name(run, column, arguments, place)), 0, 1)
            color = (place - is_dashed * len(solid)) * len(columns) + i
            plot.SetColor(*COLORS[color % len(COLORS)], 255)
            plot.SetWidth(2)
            if is_dashed:
                plot.GetPen().SetLineType(vtk.vtkPen.DASH_LINE)


def titled(name, unit):
    return f"{name} ({unit})" if unit else name


def picture_of_curves(arguments):
    table = Table(arguments.run, arguments.table)
    columns = table.matching(arguments.columns) or usual_columns(table)
    over = arguments.over or table.names[0]
    panels = [[column] for column in columns] if arguments.panels else [columns]
    matrix = vtk.vtkChartMatrix()
    matrix.SetSize(vtk.vtkVector2i(len(panels), 1))
    matrix.SetGutterX(85)
    matrix.SetBorders(70, 55, 20, 15)
    for i, group in enumerate(panels):
        chart = matrix.GetChart(vtk.vtkVector2i(i, 0))
        add_plots(chart, group, over, arguments)
        units = " / ".join(sorted({table.units.get(column, "") for column in group}))
        label_axes(chart, {
            vtk.vtkAxis.BOTTOM: titled(over, table.units.get(over, "")),
            vtk.vtkAxis.LEFT: titled(group[0], units) if arguments.panels else units})
        if i == 0:
            place_legend(chart, arguments.legend)

    view = vtk.vtkContextView()
    view.GetRenderer().SetBackground(1, 1, 1)
    view.GetScene().AddItem(matrix)
    window = view.GetRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(arguments.width, round(0.45 * arguments.width))
    return png_of(window, 1)
