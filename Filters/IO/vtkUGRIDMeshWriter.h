/**
 * @class   vtkUGRIDMeshWriter
 * @brief   writes a mesh for AFLR3, FUN3D and others (.ugrid, with .mapbc)
 *
 * The end of the name decides: mesh.b8.ugrid is binary with big-endian numbers, mesh.lb8.ugrid with little-endian
 * ones, mesh.ugrid is text (with as many digits as give the same numbers when read). Beside it mesh.mapbc is
 * written: for each patch its number, FUN3D's boundary condition for its type, and its name. Boundary faces are
 * turned into the mesh. Patches inside the mesh cannot be held; several regions are
 * told by the format's optional records of volume numbers.
 *
 * Input, errors, files: see vtkSolverMeshWriter; formats.md has the format's page.
 */
#ifndef vtkUGRIDMeshWriter_h
#define vtkUGRIDMeshWriter_h

#include "vtkSolverMeshWriter.h"

class RANSMESHINGIO_EXPORT vtkUGRIDMeshWriter : public vtkSolverMeshWriter
{
public:
  static vtkUGRIDMeshWriter* New();
  vtkTypeMacro(vtkUGRIDMeshWriter, vtkSolverMeshWriter);

protected:
  vtkUGRIDMeshWriter() = default;
  ~vtkUGRIDMeshWriter() override = default;

  ransmesh::Outcome WriteMesh(const ransmesh::MeshView& mesh) override;

private:
  vtkUGRIDMeshWriter(const vtkUGRIDMeshWriter&) = delete;
  void operator=(const vtkUGRIDMeshWriter&) = delete;
};

#endif
