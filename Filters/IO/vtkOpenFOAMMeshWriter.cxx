// The format: OpenFOAM user guide, "Mesh description"; binary files as OpenFOAM 1912 writes them.
#include "vtkOpenFOAMMeshWriter.h"

#include "FoamFaces.h"
#include "FoamZones.h"
#include "PlaneNormal.h"
#include "ReplacedPath.h"

#include "vtkObjectFactory.h"

#include <filesystem>
#include <limits>
#include <string_view>

vtkStandardNewMacro(vtkOpenFOAMMeshWriter);

namespace
{
using namespace ransmesh;
using namespace ransmesh::foam;

// OpenFOAM stops where a face normal of a symmetryPlane is 3e-8 off the mean; less is left to rounding.
constexpr double LargestOffPlane = 1e-8;

const char* typeOf(const BoundaryPatch& patch, const MeshView& mesh)
{
  if (patch.type == PatchType::Symmetry)
  {
    return planeNormal(mesh, patch, LargestOffPlane) ? "symmetryPlane" : "symmetry";
  }
  return patch.type == PatchType::Wall ? "wall" : "patch";
}

// By which fields name all patches of a type at once: ours, but OpenFOAM's own for constraints. A plane patch
// in a group symmetry would be taken for a curved one by caseDicts/setConstraintTypes.
std::string_view groupOf(const BoundaryPatch& patch, const MeshView& mesh)
{
  return patch.type == PatchType::Symmetry ? typeOf(patch, mesh) : nameOf(patch.type);
}

class PolyMesh
{
public:
  PolyMesh(const MeshView& mesh, const std::string& folder, bool binary)
    : mesh_(mesh)
    , folder_(folder + "/")
    , binary_(binary)
    , faces_(mesh, folder, binary)
    , labels_(foamLabels(mesh.patches()))
  {
  }

  Outcome write()
  {
    writePoints();
    if (Outcome outcome = faces_.write(); !outcome.ok())
    {
      return outcome;
    }
    note(faces_.error());
    writeBoundary();
    note(writeFaceZones(mesh_, labels_, faces_.zoneFaces(), folder_ + "faceZones"));
    note(writeCellZones(mesh_, folder_ + "cellZones"));
    return Outcome::done();
  }

  int error() const { return error_; }

private:
  void note(int error) { error_ = error_ ? error_ : error; }
  void finish(OutputFile& file)
  {
    file.close();
    note(file.error());
  }

  void writePoints()
  {
    OutputFile file(folder_ + "points");
    file.text(header("points", "vectorField", binary_));
    file.number(mesh_.numberOfPoints()).text(binary_ ? "\n(" : "\n(\n");
    for (vtkIdType i = 0; i < mesh_.numberOfPoints(); ++i)
    {
      const auto x = mesh_.point(i);
      if (binary_)
      {
        file.binary(x[0]).binary(x[1]).binary(x[2]);
      }
      else
      {
        file.text("(").number(x[0]).text(" ").number(x[1]).text(" ").number(x[2]).text(")\n");
      }
    }
    file.text(")\n");
    finish(file);
  }

  void writeBoundary()
  {
    OutputFile file(folder_ + "boundary");
    file.text(header("boundary", "polyBoundaryMesh", false));
    const auto& patches = mesh_.patches();
    const auto outer = [](const BoundaryPatch& p) { return FaceOrder::sidesOf(p) > 0; };
    file.number(std::count_if(patches.begin(), patches.end(), outer)).text("\n(\n");
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      if (!outer(patches[i]))
      {
        continue;
      }
      file.text("    ").text(labels_[i]).text("\n    {\n        type            ");
      file.text(typeOf(patches[i], mesh_)).text(";\n        inGroups        1(");
      file.text(groupOf(patches[i], mesh_)).text(");\n        nFaces          ");
      file.number(faces_.order().outerFaces(patches[i])).text(";\n        startFace       ");
      file.number(faces_.startOf(i)).text(";\n    }\n");
    }
    file.text(")\n");
    finish(file);
  }

  const MeshView& mesh_;
  std::string folder_;
  bool binary_;
  FoamFaces faces_;
  std::vector<std::string> labels_;
  int error_ = 0;
};

// An empty file that ParaView opens a case by.
int writeMarker(const std::string& path)
{
  OutputFile file(path);
  file.close();
  return file.error();
}
} // namespace

Outcome vtkOpenFOAMMeshWriter::WriteMesh(const MeshView& mesh)
{
  const std::filesystem::path asked(this->FileName);
  const bool byMarker = asked.extension() == ".foam";
  const std::string folder =
    byMarker ? (asked.parent_path() / "constant" / "polyMesh").string() : std::string(this->FileName);
  if (mesh.numberOfCells() > std::numeric_limits<std::int32_t>::max() / 6)
  {
    return Outcome::badInput("the mesh has too many cells for labels of 32 bits");
  }
  ReplacedPath path(folder, ReplacedPath::Kind::MeshFolder);
  if (Outcome outcome = path.prepare(); !outcome.ok())
  {
    return outcome;
  }
  PolyMesh polyMesh(mesh, path.temporary(), this->FileType == VTK_BINARY);
  if (Outcome outcome = polyMesh.write(); !outcome.ok())
  {
    return outcome;
  }
  const int error = polyMesh.error() != 0 || !byMarker ? polyMesh.error() : writeMarker(asked.string());
  return error != 0 ? writingFailed(this->FileName, error) : path.commit();
}
