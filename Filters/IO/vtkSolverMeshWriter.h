/**
 * @class   vtkSolverMeshWriter
 * @brief   what the writers of meshes for flow solvers have in common
 *
 * Input: a vtkUnstructuredGrid of volume cells (tetrahedra, pyramids, wedges, hexahedra) and of the faces of
 * its boundary (triangles, quadrilaterals) with the cell array PatchId, and the field data PatchNames and
 * PatchTypes, as the filters of RANSMeshing give it.
 *
 * A file is there whole or not at all: it is written under another name beside its place, then renamed. If that
 * fails (a full disk, no permission, a folder of that name), Write returns 0, with an error event and an error
 * code, and what was there before is still there.
 *
 * A patch inside the mesh, with cells on both sides (a sheet: a wake, a wall without thickness), is an error
 * where the format cannot hold it, unless LeaveOutSheets is on.
 *
 * Regions (cell array RegionId, field data RegionNames) are written as each format has them: zones, cell zones,
 * physical volumes; formats.md tells.
 *
 * @sa vtkSU2MeshWriter vtkOpenFOAMMeshWriter vtkUGRIDMeshWriter vtkCGNSMeshWriter vtkGmshMeshWriter
 */
#ifndef vtkSolverMeshWriter_h
#define vtkSolverMeshWriter_h

#include "RANSMeshingIOModule.h"
#include "vtkWriter.h"

class vtkUnstructuredGrid;

namespace ransmesh
{
class MeshView;
struct Outcome;
} // namespace ransmesh

class RANSMESHINGIO_EXPORT vtkSolverMeshWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkSolverMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where to write. Must be given.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Leave out patches inside the mesh. Right for a wake, through which the flow passes; wrong for a wall without
   * thickness. Patches that divide regions stay where files can hold these alone (SU2). Default off.
   */
  vtkSetMacro(LeaveOutSheets, bool);
  vtkGetMacro(LeaveOutSheets, bool);
  vtkBooleanMacro(LeaveOutSheets, bool);
  ///@}

  ///@{
  /**
   * The mesh to be written, or null.
   */
  vtkUnstructuredGrid* GetInput();
  vtkUnstructuredGrid* GetInput(int port);
  ///@}

  /**
   * A new writer for what a file name ends in: .su2, .ugrid (.b8.ugrid, .lb8.ugrid), .cgns, .msh, .foam, or
   * the whole name polyMesh. Null for others. The caller owns it; its FileName is set.
   */
  VTK_NEWINSTANCE
  static vtkSolverMeshWriter* NewForFile(const char* fileName);

  /**
   * Can files of this name hold patches inside the mesh (wakes, walls without thickness)?
   */
  virtual bool CanHoldSheets() { return false; }

  /**
   * Can they hold such patches where they divide two regions of the mesh (cell array RegionId)?
   */
  virtual bool CanHoldDividingSheets() { return this->CanHoldSheets(); }

protected:
  vtkSolverMeshWriter();
  ~vtkSolverMeshWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  // Writes the whole mesh.
  virtual ransmesh::Outcome WriteMesh(const ransmesh::MeshView& mesh) = 0;

  char* FileName = nullptr;
  bool LeaveOutSheets = false;

private:
  ransmesh::Outcome WriteView(ransmesh::MeshView& mesh);

  vtkSolverMeshWriter(const vtkSolverMeshWriter&) = delete;
  void operator=(const vtkSolverMeshWriter&) = delete;
};

#endif
