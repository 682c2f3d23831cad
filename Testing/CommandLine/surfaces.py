"""Small surfaces for the tests, and files of them."""
import math

BOX_SIDES = ("left", "right", "front", "back", "bottom", "top")


def box(size=(1.0, 1.0, 1.0), cells=4):
    """A box from the origin: points, and triangles (turned outward) by the side's name."""
    points, numbers, sides = [], {}, {name: [] for name in BOX_SIDES}

    def point(x):
        key = tuple(round(v, 12) for v in x)
        if key not in numbers:
            numbers[key] = len(points)
            points.append(x)
        return numbers[key]

    for number, name in enumerate(BOX_SIDES):
        axis, high = number // 2, number % 2
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for i in range(cells):
            for j in range(cells):
                corners = []
                for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    x = [0.0, 0.0, 0.0]
                    x[axis] = size[axis] * high
                    x[u] = size[u] * (i + di) / cells
                    x[v] = size[v] * (j + dj) / cells
                    corners.append(point(tuple(x)))
                a, b, c, d = corners if high else corners[::-1]
                sides[name] += [(a, b, c), (a, c, d)]
    return points, sides


def sphere(radius=1.0, rings=12, around=20):
    """A closed sphere: points and triangles."""
    points = [(0.0, 0.0, radius)]
    for ring in range(1, rings):
        polar = math.pi * ring / rings
        for i in range(around):
            angle = 2 * math.pi * i / around
            points.append((radius * math.sin(polar) * math.cos(angle),
                           radius * math.sin(polar) * math.sin(angle), radius * math.cos(polar)))
    points.append((0.0, 0.0, -radius))
    triangles = [(0, 1 + i, 1 + (i + 1) % around) for i in range(around)]
    for ring in range(rings - 2):
        low, high = 1 + ring * around, 1 + (ring + 1) * around
        for i in range(around):
            j = (i + 1) % around
            triangles += [(low + i, high + i, low + j), (low + j, high + i, high + j)]
    last = len(points) - 1
    first = last - around
    triangles += [(first + i, last, first + (i + 1) % around) for i in range(around)]
    return points, triangles


def sheet(corner, first, second, cells):
    """A parallelogram at a corner, with two sides: points and triangles."""
    points = [tuple(corner[k] + first[k] * i / cells + second[k] * j / cells for k in range(3))
              for j in range(cells + 1) for i in range(cells + 1)]
    triangles = []
    for j in range(cells):
        for i in range(cells):
            a = j * (cells + 1) + i
            triangles += [(a, a + 1, a + cells + 2), (a, a + cells + 2, a + cells + 1)]
    return points, triangles


def stl_text(points, groups):
    lines = []
    for name, triangles in groups.items():
        lines.append(f"solid {name}")
        for triangle in triangles:
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex {!r} {!r} {!r}".format(*points[v]) for v in triangle]
            lines += ["endloop", "endfacet"]
        lines.append(f"endsolid {name}")
    return "\n".join(lines) + "\n"


def obj_text(points, groups):
    lines = ["v {!r} {!r} {!r}".format(*p) for p in points]
    for name, triangles in groups.items():
        lines.append(f"g {name}")
        lines += ["f " + " ".join(str(v + 1) for v in triangle) for triangle in triangles]
    return "\n".join(lines) + "\n"


def ply_text(points, triangles):
    head = ["ply", "format ascii 1.0", f"element vertex {len(points)}", "property double x", "property double y",
            "property double z", f"element face {len(triangles)}", "property list uchar int vertex_indices",
            "end_header"]
    body = ["{!r} {!r} {!r}".format(*p) for p in points] + ["3 {} {} {}".format(*t) for t in triangles]
    return "\n".join(head + body) + "\n"


def vtp_text(points, triangles, array, numbers):
    """With a cell array of numbers."""
    def data(kind, name, values, components=1):
        return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">' +
                " ".join(map(repr, values)) + "</DataArray>")

    return (f'<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PolyData>'
            f'<Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(triangles)}"><Points>' +
            data("Float64", "Points", [x for point in points for x in point], 3) + "</Points><Polys>" +
            data("Int64", "connectivity", [v for triangle in triangles for v in triangle]) +
            data("Int64", "offsets", [3 * (i + 1) for i in range(len(triangles))]) + "</Polys><CellData>" +
            data("Int32", array, numbers) + "</CellData></Piece></PolyData></VTKFile>\n")
