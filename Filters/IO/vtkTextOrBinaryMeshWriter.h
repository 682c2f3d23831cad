/**
 * @class   vtkTextOrBinaryMeshWriter
 * @brief   what the writers of formats have in common that are binary or text as the user likes
 *
 * @sa vtkOpenFOAMMeshWriter vtkGmshMeshWriter
 */
#ifndef vtkTextOrBinaryMeshWriter_h
#define vtkTextOrBinaryMeshWriter_h

#include "vtkSolverMeshWriter.h"

class RANSMESHINGIO_EXPORT vtkTextOrBinaryMeshWriter : public vtkSolverMeshWriter
{
public:
  vtkTypeMacro(vtkTextOrBinaryMeshWriter, vtkSolverMeshWriter);
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
  vtkTextOrBinaryMeshWriter() = default;
  ~vtkTextOrBinaryMeshWriter() override = default;

  int FileType = VTK_BINARY;

private:
  vtkTextOrBinaryMeshWriter(const vtkTextOrBinaryMeshWriter&) = delete;
  void operator=(const vtkTextOrBinaryMeshWriter&) = delete;
};

#endif
