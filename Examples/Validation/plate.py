"""A slab above a flat plate that begins at x = 0, with symmetry before it."""
import numpy

import meshing
import slab

TYPES = {"plate": "wall", "upstream": "symmetry", "front": "symmetry", "back": "symmetry", "top": "farfield",
         "inlet": "inlet", "outlet": "outlet"}
END, HEIGHT = 2.0, 1.0


def make_mesh(start, size, layers, prisms=False):
    """From x = start < 0, one triangle's edge, size, deep. layers: first height, growth, number."""

    def patch_of(point):
        x, y, z = point
        if z < 1e-9:
            return "plate" if x > 0 else "upstream"
        if z > HEIGHT - 1e-9:
            return "top"
        if x < start + 1e-9:
            return "inlet"
        if x > END - 1e-9:
            return "outlet"
        return "front" if y < 1e-9 else "back"

    x = numpy.concatenate([slab.even(start, 0, size)[:-1], slab.even(0, END, size)])
    surface = slab.box(x, numpy.array([0, size]), slab.even(0, HEIGHT, size), patch_of, TYPES)
    # The layers go on before the plate: there is no step at its leading edge then.
    return meshing.make_mesh(surface, {name: layers for name in ("plate", "upstream")}, prisms=prisms)
