// The parts of a polyMesh folder's files that are the same in all: header, lists of numbers.
#ifndef FoamFile_h
#define FoamFile_h

#include "OutputFile.h"

#include "vtkType.h"

#include <cstdint>
#include <string>

namespace ransmesh::foam
{
// The header of the file `object`, of an OpenFOAM class. note: a remark that OpenFOAM reads, or empty.
std::string header(
  const std::string& object, const std::string& className, bool binary, const std::string& note = "");

// A list of labels (32 bits), written one after the other: binary or one a line. Its length must be known.
class LabelList
{
public:
  LabelList(OutputFile& file, bool binary, vtkIdType length)
    : file_(file)
    , binary_(binary)
  {
    file_.number(length).text(binary_ ? "\n(" : "\n(\n");
  }
  void add(vtkIdType label)
  {
    if (binary_)
    {
      file_.binary(static_cast<std::int32_t>(label));
    }
    else
    {
      file_.number(label).text("\n");
    }
  }
  void end() { file_.text(")\n"); }

private:
  OutputFile& file_;
  bool binary_;
};
} // namespace ransmesh::foam

#endif
