#!/usr/bin/env python3
"""The lid-driven cavity, Re = 1000, in a slab 1 x 1 x 0.1 with layers on its four walls: cavity.py FOLDER [--quick]

Tetrahedra by finite elements (finite_elements.py), prisms by OpenFOAM's simpleFoam, against U. Ghia, K.N. Ghia and C.T.
Shin, J. Comput. Phys. 48 (1982) 387-411 (reference/ghia1982_re1000.csv). Leaves in FOLDER the results, a picture and
figures.json. --quick: a coarse mesh, tetrahedra alone, with a limit of its own.
Status 1 where u or v on the centre lines are off by more than 0.025 (quick: 0.06) at a point, or by 0.010 (0.03) in the
root mean square.
"""
import json
import os
import sys
import time

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import compare
import elements
import meshing
import openfoam
import slab

REYNOLDS = 1000
DEPTH = 0.1
STEPS = 600  # of simpleFoam
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


def by_finite_elements(folder, mesh):
    still = [(patch, component, 0.0) for patch in ("walls", "lid") for component in (0, 1, 2)]
    sides = [(side, 2, 0.0) for side in ("front", "back")]
    # Walls come after the lid: its corners stand still.
    conditions = sides + still[3:] + [("lid", 0, 1.0)] + still[:3]
    velocity, _ = elements.solve(os.path.join(folder, "tetrahedra"), mesh, conditions,
                                 [1 / re for re in (100, 350, REYNOLDS)], point_pressure=True)
    return velocity


def by_openfoam(folder, mesh):
    case = openfoam.Case(os.path.join(folder, "prisms"))
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
    """Differences of u on x = 0.5 and of v on y = 0.5 from the table, and the values."""
    middle = DEPTH / 2
    u = sampler([(0.5, y, middle) for y in table["y"]])[:, 0]
    v = sampler([(x, 0.5, middle) for x in table["x"]])[:, 1]
    return u, v


def judge(u, v, table):
    difference = numpy.concatenate([u - table["u"], v - table["v"]])
    return {"largest": float(numpy.abs(difference).max()), "rms": float(numpy.sqrt((difference ** 2).mean()))}


def run(folder, quick):
    """0 where the figures are good, else 1."""
    size, height, growth, layers, most, most_rms = QUICK if quick else FULL
    table = reference()
    results, curves = {}, []
    for name, prisms in (("tetrahedra, finite elements", False), ("prisms, simpleFoam", True))[:1 if quick else 2]:
        print(f"-- {name}", flush=True)
        start = time.time()
        mesh = make_mesh(size, height, growth, layers, prisms)
        velocity = by_openfoam(folder, mesh) if prisms else by_finite_elements(folder, mesh)
        sampler = elements.sampler(mesh, velocity, of_cells=prisms)
        u, v = on_centre_lines(sampler, table)
        types = vtk_to_numpy(mesh.GetCellTypesArray())
        results[name] = {**judge(u, v, table), "cells": int(numpy.isin(types, (10, 12, 13, 14)).sum()),
                         "seconds": time.time() - start}
        fine = numpy.linspace(0.001, 0.999, 200)
        line = {"x": fine, "y": fine}
        curves.append((name, fine, *on_centre_lines(sampler, line)))
        print(f"{results[name]['cells']} cells: largest deviation {results[name]['largest']:.4f}, root mean square "
              f"{results[name]['rms']:.4f}; {results[name]['seconds']:.0f} s", flush=True)
    with open(os.path.join(folder, "figures.json"), "w", encoding="utf-8") as file:
        json.dump(results, file, indent=2)
    print(compare.centre_lines(os.path.join(folder, "cavity.png"), curves, table, "Lid-driven cavity, Re = 1000"))
    first = results["tetrahedra, finite elements"]
    return 0 if first["largest"] <= most and first["rms"] <= most_rms else 1


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--quick"]):
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    os.makedirs(sys.argv[1], exist_ok=True)
    sys.exit(run(sys.argv[1], bool(sys.argv[2:])))
