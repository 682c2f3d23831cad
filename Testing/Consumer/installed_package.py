"""The installed Python package works by PYTHONPATH alone: installed_package.py PREFIX"""
import sys

import ransmeshing
from ransmeshing import vtkIsotropicTetMesher
from vtkmodules.vtkFiltersSources import vtkCubeSource

assert ransmeshing.__file__.startswith(sys.argv[1]), ransmeshing.__file__

cube = vtkCubeSource()
mesher = vtkIsotropicTetMesher()
mesher.AddInputConnection(cube.GetOutputPort())
mesher.Update()
assert mesher.GetOutput().GetNumberOfCells() > 0
