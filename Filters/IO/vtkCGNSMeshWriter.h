/**
 * @class   vtkCGNSMeshWriter
 * @brief   writes a mesh as a CGNS file (.cgns), in HDF5
 *
 * One base, one unstructured zone; a section of elements for each kind of cell and for each patch, with the
 * patch's name; for each patch a family, whose boundary condition is of the type that corresponds to the patch's,
 * and a BC_t of the section's range of elements that names the family. A wake is a section with a family, without
 * a BC_t; a wall without thickness is refused. Where there are several regions, each has sections of its own, and a
 * ZoneSubRegion_t with a family of its name.
 *
 * Input, errors, files: see vtkSolverMeshWriter; formats.md has the format's page.
 */
#ifndef vtkCGNSMeshWriter_h
#define vtkCGNSMeshWriter_h

#include "vtkSolverMeshWriter.h"

class RANSMESHINGIO_EXPORT vtkCGNSMeshWriter : public vtkSolverMeshWriter
{
public:
  static vtkCGNSMeshWriter* New();
  vtkTypeMacro(vtkCGNSMeshWriter, vtkSolverMeshWriter);

  bool CanHoldSheets() override { return true; }

protected:
  vtkCGNSMeshWriter() = default;
  ~vtkCGNSMeshWriter() override = default;

  ransmesh::Outcome WriteMesh(const ransmesh::MeshView& mesh) override;

private:
  vtkCGNSMeshWriter(const vtkCGNSMeshWriter&) = delete;
  void operator=(const vtkCGNSMeshWriter&) = delete;
};

#endif
