/**
 * @class   vtkOpenFOAMMeshWriter
 * @brief   writes a mesh for OpenFOAM (a folder polyMesh)
 *
 * FileName is the folder, which must end in polyMesh (case/constant/polyMesh), or a file case/name.foam: the mesh
 * then goes to case/constant/polyMesh, and the file, which is empty, lets ParaView open the case.
 *
 * Faces are in upper-triangular order. Patches of type wall become wall, symmetry symmetryPlane (symmetry if it is
 * not plane), all others patch, with their type as a group. A wake becomes a face zone; a wall without thickness,
 * a patch with the faces of both its sides.
 *
 * Input, errors, files: see vtkSolverMeshWriter; formats.md has the format's page.
 */
#ifndef vtkOpenFOAMMeshWriter_h
#define vtkOpenFOAMMeshWriter_h

#include "vtkSolverMeshWriter.h"

class RANSMESHINGIO_EXPORT vtkOpenFOAMMeshWriter : public vtkSolverMeshWriter
{
public:
  static vtkOpenFOAMMeshWriter* New();
  vtkTypeMacro(vtkOpenFOAMMeshWriter, vtkSolverMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * VTK_BINARY (2, the default) or VTK_ASCII (1). Text holds as many digits as give the same numbers when read.
   */
  vtkSetClampMacro(FileType, int, VTK_ASCII, VTK_BINARY);
  vtkGetMacro(FileType, int);
  void SetFileTypeToASCII() { this->SetFileType(VTK_ASCII); }
  void SetFileTypeToBinary() { this->SetFileType(VTK_BINARY); }
  ///@}

  bool CanHoldSheets() override { return true; }

protected:
  vtkOpenFOAMMeshWriter() = default;
  ~vtkOpenFOAMMeshWriter() override = default;

  ransmesh::Outcome WriteMesh(const ransmesh::MeshView& mesh) override;

  int FileType = VTK_BINARY;

private:
  vtkOpenFOAMMeshWriter(const vtkOpenFOAMMeshWriter&) = delete;
  void operator=(const vtkOpenFOAMMeshWriter&) = delete;
};

#endif
