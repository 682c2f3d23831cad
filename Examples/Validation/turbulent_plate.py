#!/usr/bin/env python3
"""The turbulent flat plate, Re = 5e6 per length, with the Spalart-Allmaras model: turbulent_plate.py FOLDER [--quick]

Meshes a slab above a plate (x from 0 to 2, symmetry before it), runs OpenFOAM's simpleFoam on prisms and on prisms
with tetrahedra above them, in two sizes, and compares the skin friction with NASA's (reference/tmr_flat_plate_sa.csv).
Leaves in FOLDER the cases, a picture and figures.json. --quick: the smallest case alone.
Status 1 where the skin friction is off by more than 1 %, scatters by more than 0.5 % or still drifts.
"""
import os

import numpy

import compare
import example
import openfoam
import plate

VISCOSITY = 2e-7  # at unit velocity
GROWTH = 1.2
STATION = 0.970084071
REFERENCE = 2.729090163e-3  # FUN3D, incompressible, finest grid

# Name: edge length, first height, number of layers, iterations (a multiple of the window).
CASES = {
    "prisms, coarse": (0.05, 5e-6, 48, 600),
    "prisms, fine": (0.03, 2e-6, 52, 600),
    "prisms and tetrahedra, coarse": (0.05, 5e-6, 40, 600),
    "prisms and tetrahedra, fine": (0.03, 2e-6, 45, 600),
}
WINDOW = 200  # iterations over which the skin friction must not drift


def fields():
    symmetry = "type symmetryPlane;"
    sides = {"upstream": symmetry, "front": symmetry, "back": symmetry}
    zero = "type zeroGradient;"
    turbulent = 3 * VISCOSITY
    chi3 = 27.0
    eddy = VISCOSITY * 3 * chi3 / (chi3 + 7.1 ** 3)
    return {
        "U": ("[0 1 -1 0 0 0 0]", "(1 0 0)", {
            **sides, "inlet": "type fixedValue; value uniform (1 0 0);", "plate": "type noSlip;",
            "top": "type inletOutlet; inletValue uniform (1 0 0); value uniform (1 0 0);",
            "outlet": "type inletOutlet; inletValue uniform (1 0 0); value uniform (1 0 0);"}),
        "p": ("[0 2 -2 0 0 0 0]", "0", {
            **sides, "inlet": zero, "plate": zero, "top": "type fixedValue; value uniform 0;",
            "outlet": "type fixedValue; value uniform 0;"}),
        "nuTilda": ("[0 2 -1 0 0 0 0]", f"{turbulent:.10g}", {
            **sides, "inlet": f"type fixedValue; value uniform {turbulent:.10g};",
            "plate": "type fixedValue; value uniform 0;",
            "top": f"type inletOutlet; inletValue uniform {turbulent:.10g}; value uniform {turbulent:.10g};",
            "outlet": f"type inletOutlet; inletValue uniform {turbulent:.10g}; value uniform {turbulent:.10g};"}),
        "nut": ("[0 2 -1 0 0 0 0]", f"{eddy:.10g}", {
            **sides, "inlet": "type calculated; value uniform 0;", "plate": "type fixedValue; value uniform 0;",
            "top": "type calculated; value uniform 0;", "outlet": "type calculated; value uniform 0;"}),
    }


def skin_friction(case, step):
    """x and Cf on the plate's faces, by x."""
    x = case.on_patch(step, "C", "plate")[:, 0]
    friction = 2 * numpy.abs(case.on_patch(step, "wallShearStress", "plate")[:, 0])
    order = numpy.argsort(x)
    return x[order], friction[order]


def at_station(x, friction):
    """Cf at the station and its scatter: a line through log Cf over log x, and what faces differ from it."""
    near = (x > 0.6) & (x < 1.4)
    fit = numpy.polyfit(numpy.log(x[near]), numpy.log(friction[near]), 2)
    scatter = numpy.std(numpy.log(friction[near]) - numpy.polyval(fit, numpy.log(x[near])))
    return float(numpy.exp(numpy.polyval(fit, numpy.log(STATION)))), float(scatter)


def compute(path, size, height, layers, steps):
    mesh = plate.make_mesh(-0.33, size, (height, GROWTH, layers), prisms=True)
    case = openfoam.Case(path)
    openfoam.write_mesh(mesh, case)
    case.set_up(VISCOSITY, "SpalartAllmaras", fields(), steps, WINDOW)
    case.run("simpleFoam")
    last = f"{steps - WINDOW},{steps}"
    case.run("simpleFoam", "-postProcess", "-func", "wallShearStress", "-time", last)
    case.run("postProcess", "-func", "writeCellCentres", "-time", last)
    x, friction = skin_friction(case, steps)
    value, scatter = at_station(x, friction)
    before, _ = at_station(*skin_friction(case, steps - WINDOW))
    figures = {"cells": mesh.GetNumberOfCells(), "cf": value, "deviation": value / REFERENCE - 1,
               "scatter": scatter, "drift": abs(value / before - 1)}
    return figures, x, friction


def describe(figures):
    return (f"Cf {figures['cf']:.4e} at x = 0.97, {100 * figures['deviation']:+.2f} % of NASA's; scatter "
            f"{100 * figures['scatter']:.2f} %, drift {100 * figures['drift']:.3f} % over {WINDOW} iterations")


def is_good(figures):
    return abs(figures["deviation"]) <= 0.01 and figures["scatter"] <= 0.005 and figures["drift"] < 0.001


def run(folder, quick):
    """0 where the figures are good, else 1."""
    cases = dict(list(CASES.items())[:1] if quick else CASES)
    results, curves = example.run_cases(folder, cases, compute, describe)
    print(compare.skin_friction(os.path.join(folder, "turbulent_plate.png"), curves,
                                "Turbulent flat plate, Spalart-Allmaras", [(STATION, REFERENCE, "NASA, FUN3D")]))
    return 0 if all(is_good(figures) for figures in results.values()) else 1


if __name__ == "__main__":
    example.main(__doc__, run)
