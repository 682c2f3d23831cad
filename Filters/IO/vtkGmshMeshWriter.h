/**
 * @class   vtkGmshMeshWriter
 * @brief   writes a mesh in gmsh's format 2.2 (.msh)
 *
 * For gmsh itself and the many solvers and converters that read its files. Each patch is a physical surface, the
 * fluid a physical volume, with their names; types, which the format has no place for, are told in a section of
 * comments. Patches inside the mesh are surfaces like the others.
 *
 * Input, errors, files: see vtkSolverMeshWriter; formats.md has the format's page.
 */
#ifndef vtkGmshMeshWriter_h
#define vtkGmshMeshWriter_h

#include "vtkSolverMeshWriter.h"

class RANSMESHINGIO_EXPORT vtkGmshMeshWriter : public vtkSolverMeshWriter
{
public:
  static vtkGmshMeshWriter* New();
  vtkTypeMacro(vtkGmshMeshWriter, vtkSolverMeshWriter);
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
  vtkGmshMeshWriter() = default;
  ~vtkGmshMeshWriter() override = default;

  ransmesh::Outcome WriteMesh(const ransmesh::MeshView& mesh) override;

  int FileType = VTK_BINARY;

private:
  vtkGmshMeshWriter(const vtkGmshMeshWriter&) = delete;
  void operator=(const vtkGmshMeshWriter&) = delete;
};

#endif
