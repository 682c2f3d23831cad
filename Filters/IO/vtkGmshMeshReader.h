/**
 * @class   vtkGmshMeshReader
 * @brief   reads a mesh from gmsh's formats 2.2 and 4.1 (.msh)
 *
 * Output: points, tetrahedra, triangles (and what else of the volume the file holds); lines and points are left
 * out, elements of second order keep their corners. Cell array PatchId: 0 on volumes, on surfaces the number of
 * the physical group, or, in a file without physical surfaces, of the surface itself. Field data PatchNames: the
 * groups' names, else patch_<number>; PatchTypes: what vtkGmshMeshWriter left in a comment, else what the names
 * suggest.
 *
 * vtkMeshAdoption makes what it gives fit for the chain. Files of format 4.0, 3 or 1: save them anew by
 * `gmsh in.msh -save -format msh41 -o out.msh`.
 */
#ifndef vtkGmshMeshReader_h
#define vtkGmshMeshReader_h

#include "RANSMeshingIOModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

class RANSMESHINGIO_EXPORT vtkGmshMeshReader : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGmshMeshReader* New();
  vtkTypeMacro(vtkGmshMeshReader, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Must be given.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkGmshMeshReader();
  ~vtkGmshMeshReader() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkGmshMeshReader(const vtkGmshMeshReader&) = delete;
  void operator=(const vtkGmshMeshReader&) = delete;
};

#endif
