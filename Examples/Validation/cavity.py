#!/usr/bin/env python3
"""The lid-driven cavity, Re = 1000, in a slab 1 x 1 x 0.1 with layers on its four walls: cavity.py FOLDER [--quick]

Tetrahedra by finite elements (finite_elements.py), prisms by OpenFOAM's simpleFoam, against U. Ghia, K.N. Ghia and C.T.
Shin, J. Comput. Phys. 48 (1982) 387-411 (reference/ghia1982_re1000.csv). Leaves in FOLDER the results, a picture and
figures.json. --quick: a coarse mesh, tetrahedra alone, with a limit of its own.
Status 1 where u or v on the centre lines are off by more than 0.025 (quick: 0.06) at a point, or by 0.010 (0.03) in the
root mean square.
"""
import os

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import compare
import elements
import example
import meshing
import openfoam
import slab

REYNOLDS = 1000
DEPTH = 0.1
STEPS = 600  # of simpleFoam
TETRAHEDRA = "tetrahedra, finite elements"
TYPES = {"lid": "wall", "walls": "wall", "front": "symmetry", "back": "symmetry"}
#         edge, first height, growth, layers; largest deviation, root mean square
FULL = (0.0238, 0.003, 1.25, 10, 0.025, 0.010)
QUICK = (0.05, 0.008, 1.25, 5, 0.06, 0.03)


def patch_of(point):
    if point[2] < 1e-9:
        return "front"
    if point[2] > DEPTH - 1e-9:
        return "back"
    return "lid" if point[1] > 1 - 1e-9 else "walls"


def make_mesh(size, height, growth, layers, prisms=False):
    line = slab.even(0, 1, size)
    surface = slab.box(line, line, slab.even(0, DEPTH, size), patch_of, TYPES)
    layers = {name: (height, growth, layers) for name in ("lid", "walls")}
    return meshing.make_mesh(surface, layers, size, prisms)


def reference():
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "reference", "ghia1982_re1000.csv")
    return numpy.genfromtxt(path, delimiter=",", names=True, comments="#", skip_header=2)


def by_finite_elements(path, mesh):
    still = [(patch, component, 0.0) for patch in ("walls", "lid") for component in (0, 1, 2)]
    sides = [(side, 2, 0.0) for side in ("front", "back")]
    # Walls come after the lid: its corners stand still.
    conditions = sides + still[3:] + [("lid", 0, 1.0)] + still[:3]
    velocity, _ = elements.solve(path, mesh, conditions,
                                 [1 / re for re in (100, 350, REYNOLDS)], point_pressure=True)
    return velocity


def by_openfoam(path, mesh):
    case = openfoam.Case(path)
    openfoam.write_mesh(mesh, case)
    symmetry = "type symmetryPlane;"
    sides = {"front": symmetry, "back": symmetry}
    fields = {"U": ("[0 1 -1 0 0 0 0]", "(0 0 0)", {
                  **sides, "walls": "type noSlip;", "lid": "type fixedValue; value uniform (1 0 0);"}),
              "p": ("[0 2 -2 0 0 0 0]", "0", {**sides, "walls": "type zeroGradient;", "lid": "type zeroGradient;"})}
    case.set_up(1 / REYNOLDS, "laminar", fields, STEPS, STEPS, "pRefCell 0; pRefValue 0;")
    case.run("simpleFoam")
    return case.inside(STEPS, "U")


def on_centre_lines(sampler, table):
    """u on x = 0.5 and v on y = 0.5, at the places of a table."""
    middle = DEPTH / 2
    u = sampler([(0.5, y, middle) for y in table["y"]])[:, 0]
    v = sampler([(x, 0.5, middle) for x in table["x"]])[:, 1]
    return u, v


def judge(u, v, table):
    difference = numpy.concatenate([u - table["u"], v - table["v"]])
    return {"largest": float(numpy.abs(difference).max()), "rms": float(numpy.sqrt((difference ** 2).mean()))}


def run(folder, quick):
    """0 where the figures are good, else 1."""
    *sizes, most, most_rms = QUICK if quick else FULL
    table = reference()

    def compute(path, prisms):
        mesh = make_mesh(*sizes, prisms)
        velocity = by_openfoam(path, mesh) if prisms else by_finite_elements(path, mesh)
        sampler = elements.sampler(mesh, velocity, of_cells=prisms)
        types = vtk_to_numpy(mesh.GetCellTypesArray())
        figures = {**judge(*on_centre_lines(sampler, table), table),
                   "cells": int(numpy.isin(types, (10, 12, 13, 14)).sum())}
        fine = numpy.linspace(0.001, 0.999, 200)
        return figures, fine, *on_centre_lines(sampler, {"x": fine, "y": fine})

    cases = {TETRAHEDRA: (False,)} if quick else {TETRAHEDRA: (False,), "prisms, simpleFoam": (True,)}
    results, curves = example.run_cases(folder, cases, compute, describe)
    print(compare.centre_lines(os.path.join(folder, "cavity.png"), curves, table, "Lid-driven cavity, Re = 1000"))
    first = results[TETRAHEDRA]
    return 0 if first["largest"] <= most and first["rms"] <= most_rms else 1


def describe(figures):
    return f"{figures['cells']} cells: largest deviation {figures['largest']:.4f}, root mean square {figures['rms']:.4f}"


if __name__ == "__main__":
    example.main(__doc__, run)
