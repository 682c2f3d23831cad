// The format: https://www.simcenter.msstate.edu/software/documentation/ug_io/3d_grid_file_type_ugrid.html;
// boundary conditions: FUN3D manual, "Boundary conditions".
#include "vtkUGRIDMeshWriter.h"

#include "MeshView.h"
#include "OutputFile.h"
#include "PatchLabels.h"
#include "PlaneNormal.h"
#include "ReplacedPath.h"

#include "vtkObjectFactory.h"

#include <cmath>
#include <cstdint>
#include <limits>

vtkStandardNewMacro(vtkUGRIDMeshWriter);

namespace
{
using namespace ransmesh;

enum class Encoding
{
  Text,
  BigEndian,
  LittleEndian
};

Encoding encodingOf(std::string_view path)
{
  return path.ends_with(".b8.ugrid") ? Encoding::BigEndian
    : path.ends_with(".lb8.ugrid")   ? Encoding::LittleEndian
                                     : Encoding::Text;
}

// mesh.b8.ugrid: mesh.mapbc
std::string conditionsPathFor(std::string_view path)
{
  for (const std::string_view end : { ".b8.ugrid", ".lb8.ugrid", ".ugrid" })
  {
    if (path.ends_with(end))
    {
      path.remove_suffix(end.size());
      break;
    }
  }
  return std::string(path) + ".mapbc";
}

constexpr int Viscous = 4000;
constexpr int Tangency = 3000;
constexpr int SymmetryX = 6661; // 6662 and 6663 along y and z
constexpr int RiemannFarField = 5000;
constexpr int SubsonicInflow = 7011;
constexpr int SubsonicOutflow = 7012;
constexpr int Unstated = 0; // FUN3D refuses it: the user must say

int symmetryCondition(const MeshView& mesh, const BoundaryPatch& patch)
{
  constexpr double OffPlane = 1e-6;
  const auto normal = planeNormal(mesh, patch, OffPlane);
  for (int axis = 0; normal && axis < 3; ++axis)
  {
    if (std::abs((*normal)[axis]) > 1 - OffPlane)
    {
      return SymmetryX + axis;
    }
  }
  return Tangency; // of a plane that is no coordinate plane
}

int conditionFor(const MeshView& mesh, const BoundaryPatch& patch)
{
  switch (patch.type)
  {
    case PatchType::Wall:
      return Viscous;
    case PatchType::Symmetry:
      return symmetryCondition(mesh, patch);
    case PatchType::FarField:
      return RiemannFarField;
    case PatchType::Inlet:
      return SubsonicInflow;
    case PatchType::Outlet:
      return SubsonicOutflow;
    default:
      return Unstated;
  }
}

// The records of the file, each number in its encoding.
template <Encoding Form>
class UGRIDFile
{
public:
  UGRIDFile(const MeshView& mesh, const std::string& path)
    : mesh_(mesh)
    , file_(path)
  {
  }

  int write()
  {
    writeCounts();
    for (vtkIdType i = 0; i < mesh_.numberOfPoints(); ++i)
    {
      for (const double x : mesh_.point(i))
      {
        add(x);
      }
      endLine();
    }
    writeFaces(CellKind::Triangle);
    writeFaces(CellKind::Quadrilateral);
    writeFaceNumbers(CellKind::Triangle);
    writeFaceNumbers(CellKind::Quadrilateral);
    for (const CellKind kind : VolumeKinds)
    {
      mesh_.forEachCell(kind, [this](const Corners& cell, std::size_t) { writeCell(cell); });
    }
    if (mesh_.regions().size() > 1)
    {
      writeVolumeNumbers();
    }
    file_.close();
    return file_.error();
  }

private:
  template <class Number>
  void add(Number value)
  {
    if constexpr (Form == Encoding::Text)
    {
      file_.number(value).text(" ");
    }
    else
    {
      file_.template binary<Form == Encoding::BigEndian ? std::endian::big : std::endian::little>(value);
    }
  }
  void addPoint(vtkIdType p) { add(static_cast<std::int32_t>(p + 1)); }
  void endLine()
  {
    if constexpr (Form == Encoding::Text)
    {
      file_.text("\n");
    }
  }

  void writeCounts()
  {
    for (const vtkIdType count : { mesh_.numberOfPoints(), mesh_.numberOfCells(CellKind::Triangle),
           mesh_.numberOfCells(CellKind::Quadrilateral), mesh_.numberOfCells(CellKind::Tetrahedron),
           mesh_.numberOfCells(CellKind::Pyramid), mesh_.numberOfCells(CellKind::Wedge),
           mesh_.numberOfCells(CellKind::Hexahedron) })
    {
      add(static_cast<std::int32_t>(count));
    }
    endLine();
  }

  // Turned into the mesh.
  void writeFaces(CellKind kind)
  {
    for (vtkIdType f = 0; f < mesh_.numberOfFaces(); ++f)
    {
      const Corners face = mesh_.face(f);
      for (int i = face.count - 1; face.kind == kind && i >= 0; --i)
      {
        addPoint(face[i]);
      }
      if (face.kind == kind)
      {
        endLine();
      }
    }
  }

  void writeFaceNumbers(CellKind kind)
  {
    for (std::size_t p = 0; p < mesh_.patches().size(); ++p)
    {
      const BoundaryPatch& patch = mesh_.patches()[p];
      for (vtkIdType f = 0; f < (kind == CellKind::Triangle ? patch.triangles : patch.quadrilaterals); ++f)
      {
        add(static_cast<std::int32_t>(p + 1));
        endLine();
      }
    }
  }

  void writeCell(const Corners& cell)
  {
    // A pyramid is a wedge 0 1 2, 3 4 5 there whose edge 2 5 has no length: its base is 0 1 4 3, its tip 2.
    static constexpr std::array<int, 5> pyramid = { 1, 0, 4, 2, 3 };
    for (int i = 0; i < cell.count; ++i)
    {
      addPoint(cell[cell.kind == CellKind::Pyramid ? pyramid[i] : i]);
    }
    endLine();
  }

  // Optional records of the format, at its end: how many tetrahedra are in layers, and each cell's volume.
  void writeVolumeNumbers()
  {
    add(std::int32_t{ 0 });
    endLine();
    for (const CellKind kind : VolumeKinds)
    {
      mesh_.forEachCell(kind,
        [this](const Corners&, std::size_t region)
        {
          add(static_cast<std::int32_t>(mesh_.regions()[region].id));
          endLine();
        });
    }
  }

  const MeshView& mesh_;
  OutputFile file_;
};

int writeGrid(const MeshView& mesh, const std::string& path, Encoding encoding)
{
  switch (encoding)
  {
    case Encoding::BigEndian:
      return UGRIDFile<Encoding::BigEndian>(mesh, path).write();
    case Encoding::LittleEndian:
      return UGRIDFile<Encoding::LittleEndian>(mesh, path).write();
    default:
      return UGRIDFile<Encoding::Text>(mesh, path).write();
  }
}

int writeConditions(const MeshView& mesh, const std::string& path)
{
  OutputFile file(path);
  const std::vector<std::string> labels = patchLabels(mesh.patches(), "_-.+");
  file.number(labels.size()).text("\n");
  for (std::size_t p = 0; p < labels.size(); ++p)
  {
    file.number(p + 1).text(" ").number(conditionFor(mesh, mesh.patches()[p])).text(" ");
    file.text(labels[p]).text("\n");
  }
  file.close();
  return file.error();
}
} // namespace

Outcome vtkUGRIDMeshWriter::WriteMesh(const MeshView& mesh)
{
  if (mesh.numberOfPoints() >= std::numeric_limits<std::int32_t>::max() ||
    mesh.numberOfCells() >= std::numeric_limits<std::int32_t>::max())
  {
    return Outcome::badInput("the mesh has too many points or cells for the format's 32-bit numbers");
  }
  const std::string conditions = conditionsPathFor(this->FileName);
  ReplacedPath gridPath(this->FileName, ReplacedPath::Kind::File);
  ReplacedPath conditionsPath(conditions, ReplacedPath::Kind::File);
  for (ReplacedPath* path : { &gridPath, &conditionsPath })
  {
    if (Outcome outcome = path->prepare(); !outcome.ok())
    {
      return outcome;
    }
  }
  if (const int error = writeGrid(mesh, gridPath.temporary(), encodingOf(this->FileName)))
  {
    return writingFailed(this->FileName, error);
  }
  if (const int error = writeConditions(mesh, conditionsPath.temporary()))
  {
    return writingFailed(conditions, error);
  }
  const Outcome outcome = conditionsPath.commit();
  return outcome.ok() ? gridPath.commit() : outcome;
}
