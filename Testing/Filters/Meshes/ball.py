"""A ball in a box by netgen 6.2: python3 ball.py ball-netgen.msh"""
import sys

from netgen.csg import CSGeometry, OrthoBrick, Pnt, Sphere

box = OrthoBrick(Pnt(-1, -1, -1), Pnt(3, 1, 1)).bc("farfield")
ball = Sphere(Pnt(0, 0, 0), 0.5).bc("ball")
geometry = CSGeometry()
geometry.Add(box - ball)
geometry.GenerateMesh(maxh=0.8).Export(sys.argv[1], "Gmsh2 Format")
