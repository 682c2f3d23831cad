#!/usr/bin/env python3
"""Steady incompressible flow on tetrahedra by stabilised finite elements: finite_elements.py CASE.npz RESULT.npz

Linear velocity and pressure (P1-P1) with SUPG, PSPG and LSIC, the stabilisation time from the element's metric (T.E.
Tezduyar and S. Sathe, Comput. Methods Appl. Mech. Engrg 195, 2006; Y. Bazilevs et al., ibid. 197, 2007), so that flat
tetrahedra do no harm; Newton's method with MUMPS. A process of its own: DOLFIN brings libraries that are not VTK's.

CASE.npz: points (n, 3), tetrahedra (m, 4), triangles (k, 3) and patch (k): the mesh; viscosities: the last is what is
wanted, those before lead there; conditions: a JSON list of
    {"patch": number, "component": 0..2 or "p", "value": number}
and point_pressure: true where no patch holds the pressure. RESULT.npz: velocity (n, 3), pressure (n), steps.
"""
import json
import sys

import dolfin
import numpy
import ufl
from dolfin import as_vector, div, dot, dx, grad, inner

dolfin.set_log_level(dolfin.LogLevel.ERROR)
# Galerkin's terms are of degree 2; the stabilisation's root is no polynomial and would ask for 1728 points.
dolfin.parameters["form_compiler"]["quadrature_degree"] = 2


def make_mesh(points, tetrahedra):
    mesh = dolfin.Mesh()
    editor = dolfin.MeshEditor()
    editor.open(mesh, "tetrahedron", 3, 3)
    editor.init_vertices(len(points))
    editor.init_cells(len(tetrahedra))
    for i, point in enumerate(points):
        editor.add_vertex(i, point)
    for i, cell in enumerate(numpy.sort(tetrahedra, axis=1)):
        editor.add_cell(i, cell.astype(numpy.uintp))
    editor.close(False)
    return mesh


def vertex_dofs(space, mesh):
    """The number of the unknown of each component at each vertex."""
    dofs = dolfin.vertex_to_dof_map(space)
    return dofs.reshape(mesh.num_vertices(), -1)


def weak_form(state, test, mesh, viscosity):
    u, p = as_vector([state[i] for i in range(3)]), state[3]
    v, q = as_vector([test[i] for i in range(3)]), test[3]
    inverse = ufl.inv(ufl.Jacobian(mesh))
    metric = ufl.transpose(inverse) * inverse
    tau = 1 / ufl.sqrt(dot(u, metric * u) * 4 + 36 * viscosity ** 2 * inner(metric, metric))
    tau_c = 1 / (tau * ufl.tr(metric))
    residual = dot(grad(u), u) + grad(p)  # the elements are linear: no second derivatives
    galerkin = (dot(dot(grad(u), u), v) + viscosity * inner(grad(u), grad(v)) - p * div(v) + q * div(u)) * dx
    stabilisation = (tau * dot(residual, dot(grad(v), u) + grad(q)) + tau_c * div(u) * div(v)) * dx
    return galerkin + stabilisation


def fixed_values(case, dofs):
    """Unknowns that are given, with their values; the last condition on a point wins."""
    values = {}
    for condition in json.loads(str(case["conditions"])):
        component = 3 if condition["component"] == "p" else condition["component"]
        for vertex in numpy.unique(case["triangles"][case["patch"] == condition["patch"]]):
            values[int(dofs[vertex, component])] = condition["value"]
    if bool(case["point_pressure"]):
        values[int(dofs[0, 3])] = 0.0
    return values


def newton(state, form, values, tolerance, most=30):
    """The number of steps, or an error where it does not converge."""
    rows = numpy.array(sorted(values), dtype=numpy.int32)
    vector = state.vector().get_local()
    vector[rows] = [values[r] for r in rows]
    state.vector().set_local(vector)
    tangent = dolfin.derivative(form, state)
    solver = dolfin.LUSolver("mumps")
    for step in range(1, most + 1):
        matrix, residual = dolfin.assemble(tangent), dolfin.assemble(form)
        matrix.ident(rows)
        local = residual.get_local()
        local[rows] = 0
        residual.set_local(local)
        change = state.vector().copy()
        solver.solve(matrix, change, residual)
        state.vector().axpy(-1, change)
        size = change.norm("linf")
        print(f"  step {step}: largest change {size:.2e}", flush=True)
        if size < tolerance:
            return step
        if not size < 1e6:
            break
    raise RuntimeError(f"Newton's method did not converge in {step} steps")


def main(case_file, result_file):
    case = numpy.load(case_file)
    mesh = make_mesh(case["points"], case["tetrahedra"])
    element = ufl.MixedElement([dolfin.FiniteElement("P", mesh.ufl_cell(), 1)] * 4)
    space = dolfin.FunctionSpace(mesh, element)
    state, test = dolfin.Function(space), dolfin.TestFunction(space)
    dofs = vertex_dofs(space, mesh)
    start = state.vector().get_local()
    start[dofs[:, 0]] = float(case["start_velocity"])
    state.vector().set_local(start)
    values = fixed_values(case, dofs)
    steps = 0
    for viscosity in case["viscosities"]:
        print(f"viscosity {viscosity:.4g}", flush=True)
        tolerance = 1e-6 if viscosity == case["viscosities"][-1] else 0.05  # a start for the next one
        form = weak_form(state, test, mesh, dolfin.Constant(float(viscosity)))
        steps += newton(state, form, values, tolerance)
    result = state.vector().get_local()[dofs]
    numpy.savez(result_file, velocity=result[:, :3], pressure=result[:, 3], steps=steps)
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    sys.exit(main(sys.argv[1], sys.argv[2]))
