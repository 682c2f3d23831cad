/**
 * @class   vtkOpenFOAMMeshWriter
 * @brief   writes a mesh for OpenFOAM (a folder polyMesh)
 *
 * FileName is the folder, which must end in polyMesh (case/constant/polyMesh), or a file case/name.foam: the mesh
 * then goes to case/constant/polyMesh, and the file, which is empty, lets ParaView open the case.
 *
 * Faces are in upper-triangular order. Patches of type wall become wall, symmetry symmetryPlane (symmetry if it is
 * not plane), all others patch, with their type as a group. A wake becomes a face zone; a wall without thickness,
 * a patch with the faces of both its sides. Several regions are cell zones.
 *
 * Input, errors, files: see vtkSolverMeshWriter; formats.md has the format's page.
 */
#ifndef vtkOpenFOAMMeshWriter_h
#define vtkOpenFOAMMeshWriter_h

#include "vtkTextOrBinaryMeshWriter.h"

class RANSMESHINGIO_EXPORT vtkOpenFOAMMeshWriter : public vtkTextOrBinaryMeshWriter
{
public:
  static vtkOpenFOAMMeshWriter* New();
  vtkTypeMacro(vtkOpenFOAMMeshWriter, vtkTextOrBinaryMeshWriter);

protected:
  vtkOpenFOAMMeshWriter() = default;
  ~vtkOpenFOAMMeshWriter() override = default;

  ransmesh::Outcome WriteMesh(const ransmesh::MeshView& mesh) override;

private:
  vtkOpenFOAMMeshWriter(const vtkOpenFOAMMeshWriter&) = delete;
  void operator=(const vtkOpenFOAMMeshWriter&) = delete;
};

#endif
