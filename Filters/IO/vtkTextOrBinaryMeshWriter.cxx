#include "vtkTextOrBinaryMeshWriter.h"

void vtkTextOrBinaryMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileType: " << this->FileType << '\n';
}
