#!/usr/bin/env python3
"""The laminar flat plate, Re = 1e5 per length, on all-tetrahedral layers: laminar_plate.py FOLDER [--quick]

Meshes a slab above a plate (x from 0 to 2, symmetry before it) with first heights of 1e-4 and 1e-5, aspect ratios of
500 and 5000, solves by finite elements (finite_elements.py) and compares the skin friction with Blasius's solution.
Leaves in FOLDER the results, a picture and figures.json. --quick: the first mesh alone.
Status 1 where the skin friction is off by more than 2 %, scatters by more than 1.5 %, or differs by more than 0.5 %
between the two.
"""
import os

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import compare
import elements
import example
import plate

VISCOSITY = 1e-5  # at unit velocity
SIZE = 0.05
# First height, growth, layers.
CASES = {"h0 = 1e-4": (1e-4, 1.1, 42), "h0 = 1e-5": (1e-5, 1.1, 66)}
WINDOW = (0.3, 1.7)  # of x: away from the ends


def skin_friction(mesh, velocity):
    """x and Cf above the plate: of the points of the first layer, whose heights are those of the tetrahedra there."""
    _, tetrahedra = elements.cells_of(mesh, elements.TETRAHEDRON, 4)
    numbers, triangles = elements.cells_of(mesh, elements.TRIANGLE, 3)
    patches = vtk_to_numpy(mesh.GetCellData().GetArray("PatchId"))[numbers]
    on_plate = numpy.zeros(mesh.GetNumberOfPoints(), dtype=bool)
    on_plate[triangles[patches == elements.patch_number(mesh, "plate")]] = True
    standing = tetrahedra[on_plate[tetrahedra].sum(axis=1) == 3]
    above = numpy.unique(standing[~on_plate[standing]])
    points = vtk_to_numpy(mesh.GetPoints().GetData())[above]
    order = numpy.argsort(points[:, 0])
    return points[order, 0], (2 * VISCOSITY * velocity[above, 0] / points[:, 2])[order]


def blasius(x):
    return 0.664115 / numpy.sqrt(x / VISCOSITY)


def compute(path, height, growth, layers):
    mesh = plate.make_mesh(-0.5, SIZE, (height, growth, layers))
    conditions = [("front", 1, 0.0), ("back", 1, 0.0), ("upstream", 2, 0.0), ("top", 0, 1.0)]
    conditions += [("inlet", i, float(i == 0)) for i in range(3)] + [("plate", i, 0.0) for i in range(3)]
    velocity, _ = elements.solve(path, mesh, conditions, [1e-3, 1e-4, VISCOSITY], start_velocity=1.0)
    x, friction = skin_friction(mesh, velocity)
    inside = (x > WINDOW[0]) & (x < WINDOW[1])
    ratio = friction[inside] / blasius(x[inside])
    figures = {"points": mesh.GetNumberOfPoints(), "deviation": float(ratio.mean() - 1), "scatter": float(ratio.std())}
    return figures, x, friction


def describe(figures):
    return f"Cf {100 * figures['deviation']:+.2f} % of Blasius's, scatter {100 * figures['scatter']:.2f} %"


def is_good(results):
    deviations = [figures["deviation"] for figures in results.values()]
    return (max(map(abs, deviations)) <= 0.02 and max(deviations) - min(deviations) <= 0.005 and
            all(figures["scatter"] <= 0.015 for figures in results.values()))


def run(folder, quick):
    """0 where the figures are good, else 1."""
    cases = dict(list(CASES.items())[:1] if quick else CASES)
    results, curves = example.run_cases(folder, cases, compute, describe)
    x = numpy.linspace(0.02, plate.END, 200)
    print(compare.skin_friction(os.path.join(folder, "laminar_plate.png"), curves, "Laminar flat plate, tetrahedra",
                                lines=[(x, blasius(x), "Blasius")]))
    return 0 if is_good(results) else 1


if __name__ == "__main__":
    example.main(__doc__, run)
