/**
 * @class   vtkGmshMeshWriter
 * @brief   writes a mesh in gmsh's format 2.2 (.msh)
 *
 * For gmsh itself and the many solvers and converters that read its files. Each patch is a physical surface, the
 * fluid a physical volume (each of its regions one, where there are several), with their names; types, which
 * the format has no place for, are told in a section of comments. Patches inside the mesh are surfaces like
 * the others.
 *
 * Input, errors, files: see vtkSolverMeshWriter; formats.md has the format's page.
 */
#ifndef vtkGmshMeshWriter_h
#define vtkGmshMeshWriter_h

#include "vtkTextOrBinaryMeshWriter.h"

class RANSMESHINGIO_EXPORT vtkGmshMeshWriter : public vtkTextOrBinaryMeshWriter
{
public:
  static vtkGmshMeshWriter* New();
  vtkTypeMacro(vtkGmshMeshWriter, vtkTextOrBinaryMeshWriter);

protected:
  vtkGmshMeshWriter() = default;
  ~vtkGmshMeshWriter() override = default;

  ransmesh::Outcome WriteMesh(const ransmesh::MeshView& mesh) override;

private:
  vtkGmshMeshWriter(const vtkGmshMeshWriter&) = delete;
  void operator=(const vtkGmshMeshWriter&) = delete;
};

#endif
