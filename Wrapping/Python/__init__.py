"""RANSMeshing: stretched tetrahedral meshes for RANS computations, as VTK filters.

    from ransmeshing import (vtkIsotropicTetMesher, vtkRANSPointRemoval,
                             vtkDirectionalEnrichment, vtkMeshQualityReport)
"""
# VTK's own modules hold the superclasses and must be loaded before the filters.
import vtkmodules.vtkCommonCore
import vtkmodules.vtkCommonDataModel
import vtkmodules.vtkCommonExecutionModel
import vtkmodules.vtkIOCore

from .RANSMeshingSurface import *
from .RANSMeshingTetGen import *
from .RANSMeshingBoundaryLayer import *
from .RANSMeshingIO import *
