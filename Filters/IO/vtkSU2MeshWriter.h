/**
 * @class   vtkSU2MeshWriter
 * @brief   writes a mesh for SU2 (.su2)
 *
 * Text: volume cells, points (with as many digits as give the same numbers when read), a marker for each patch.
 * SU2 takes what a marker is from its configuration, so the file begins with comments that say the patches' types
 * and give the lines for it. Several regions become several zones of the file (NZONE, IZONE); a patch that divides
 * two of them is a marker in both, with the zones' names behind its own. Other patches inside the mesh cannot be held.
 *
 * Input, errors, files: see vtkSolverMeshWriter; formats.md has the format's page.
 */
#ifndef vtkSU2MeshWriter_h
#define vtkSU2MeshWriter_h

#include "vtkSolverMeshWriter.h"

class RANSMESHINGIO_EXPORT vtkSU2MeshWriter : public vtkSolverMeshWriter
{
public:
  static vtkSU2MeshWriter* New();
  vtkTypeMacro(vtkSU2MeshWriter, vtkSolverMeshWriter);

  bool CanHoldDividingSheets() override { return true; }

protected:
  vtkSU2MeshWriter() = default;
  ~vtkSU2MeshWriter() override = default;

  ransmesh::Outcome WriteMesh(const ransmesh::MeshView& mesh) override;

private:
  vtkSU2MeshWriter(const vtkSU2MeshWriter&) = delete;
  void operator=(const vtkSU2MeshWriter&) = delete;
};

#endif
