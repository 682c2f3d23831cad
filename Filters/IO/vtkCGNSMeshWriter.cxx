// The format: CGNS Standard Interface Data Structures; libcgns writes it.
#include "vtkCGNSMeshWriter.h"

#include "MeshView.h"
#include "PatchLabels.h"
#include "ReplacedPath.h"

#include "vtkObjectFactory.h"

#include <cgnslib.h>

#include <cerrno>
#include <fcntl.h>
#include <limits>
#include <stdexcept>
#include <unistd.h>

vtkStandardNewMacro(vtkCGNSMeshWriter);

namespace
{
using namespace ransmesh;

constexpr std::size_t LongestName = 32;
constexpr std::string_view Allowed = " _-.+:()";
constexpr vtkIdType Block = 1 << 16; // points or elements that are passed on at once

constexpr std::array<CGNS_ENUMT(ElementType_t), 6> ElementTypes = { CGNS_ENUMV(TETRA_4), CGNS_ENUMV(PYRA_5),
  CGNS_ENUMV(PENTA_6), CGNS_ENUMV(HEXA_8), CGNS_ENUMV(TRI_3), CGNS_ENUMV(QUAD_4) };
constexpr std::array<const char*, 4> SectionNames = { "Tetrahedra", "Pyramids", "Wedges", "Hexahedra" };

CGNS_ENUMT(BCType_t) conditionFor(PatchType type)
{
  switch (type)
  {
    case PatchType::Wall:
      return CGNS_ENUMV(BCWallViscous);
    case PatchType::Symmetry:
      return CGNS_ENUMV(BCSymmetryPlane);
    case PatchType::FarField:
      return CGNS_ENUMV(BCFarfield);
    case PatchType::Inlet:
      return CGNS_ENUMV(BCInflow);
    case PatchType::Outlet:
      return CGNS_ENUMV(BCOutflow);
    default:
      return CGNS_ENUMV(BCTypeUserDefined);
  }
}

// Throws std::runtime_error, with the library's words, where the library fails.
void check(int status)
{
  if (status != CG_OK)
  {
    throw std::runtime_error(cg_get_error());
  }
}

class CGNSFile
{
public:
  CGNSFile(const MeshView& mesh, const std::string& path)
    : mesh_(mesh)
    , labels_(patchLabels(mesh.patches(), Allowed, LongestName))
    , regionLabels_(regionLabels(mesh.regions(), Allowed, LongestName, labels_))
  {
    check(cg_set_file_type(CG_FILE_HDF5));
    check(cg_open(path.c_str(), CG_MODE_WRITE, &file_));
    open_ = true;
  }
  ~CGNSFile()
  {
    if (open_)
    {
      cg_close(file_);
    }
  }
  CGNSFile(const CGNSFile&) = delete;
  CGNSFile& operator=(const CGNSFile&) = delete;

  void write()
  {
    check(cg_base_write(file_, "Base", 3, 3, &base_));
    const cgsize_t sizes[3] = { number(mesh_.numberOfPoints()), number(mesh_.numberOfCells()), 0 };
    check(cg_zone_write(file_, base_, "Zone", sizes, CGNS_ENUMV(Unstructured), &zone_));
    writeCoordinates();
    for (std::size_t r = 0; r < mesh_.regions().size(); ++r)
    {
      writeRegion(r);
    }
    for (std::size_t p = 0; p < labels_.size(); ++p)
    {
      writePatch(mesh_.patches()[p], labels_[p]);
    }
    open_ = false;
    check(cg_close(file_));
  }

private:
  static cgsize_t number(vtkIdType value) { return static_cast<cgsize_t>(value); }

  void writeCoordinates()
  {
    constexpr std::array<const char*, 3> names = { "CoordinateX", "CoordinateY", "CoordinateZ" };
    std::vector<double> values;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (vtkIdType first = 0; first < mesh_.numberOfPoints(); first += Block)
      {
        const vtkIdType last = std::min(first + Block, mesh_.numberOfPoints());
        values.clear();
        for (vtkIdType i = first; i < last; ++i)
        {
          values.push_back(mesh_.point(i)[axis]);
        }
        const cgsize_t from = number(first + 1);
        const cgsize_t to = number(last);
        int coordinate = 0;
        check(cg_coord_partial_write(
          file_, base_, zone_, CGNS_ENUMV(RealDouble), names[axis], &from, &to, values.data(), &coordinate));
      }
    }
  }

  void addPoints(const Corners& element)
  {
    for (const vtkIdType p : element)
    {
      points_.push_back(number(p + 1));
    }
  }

  // Passes on what points_ holds, as elements that follow those before.
  void flush(int section, cgsize_t& next)
  {
    if (!points_.empty())
    {
      const cgsize_t count = number(static_cast<vtkIdType>(points_.size())) / cornersOf_;
      check(cg_elements_partial_write(file_, base_, zone_, section, next, next + count - 1, points_.data()));
      next += count;
      points_.clear();
    }
  }

  // Sections of its own for each region. Where there are several, each is a family and a ZoneSubRegion_t of that
  // family, by the range of its elements.
  void writeRegion(std::size_t region)
  {
    const cgsize_t first = elements_ + 1;
    for (const CellKind kind : VolumeKinds)
    {
      writeCells(kind, region);
    }
    if (mesh_.regions().size() == 1)
    {
      return;
    }
    const std::string& label = regionLabels_[region];
    int number = 0;
    check(cg_family_write(file_, base_, label.c_str(), &number));
    const cgsize_t range[2] = { first, elements_ };
    check(cg_subreg_ptset_write(file_, base_, zone_, label.c_str(), 3, CGNS_ENUMV(CellCenter),
      CGNS_ENUMV(PointRange), 2, range, &number));
    check(cg_goto(file_, base_, "Zone_t", zone_, "ZoneSubRegion_t", number, "end"));
    check(cg_famname_write(label.c_str()));
  }

  // A section's name is no other's; numbered where there are several regions.
  std::string sectionName(CellKind kind, std::size_t region) const
  {
    const std::string name = SectionNames[static_cast<int>(kind)];
    return mesh_.regions().size() == 1 ? name : name + " " + std::to_string(mesh_.regions()[region].id);
  }

  void writeCells(CellKind kind, std::size_t region)
  {
    const vtkIdType count = mesh_.regions()[region].cells[static_cast<int>(kind)];
    if (count == 0)
    {
      return;
    }
    int section = 0;
    cgsize_t next = elements_ + 1;
    elements_ += number(count);
    check(cg_section_partial_write(file_, base_, zone_, sectionName(kind, region).c_str(),
      ElementTypes[static_cast<int>(kind)], next, elements_, 0, &section));
    check(cg_npe(ElementTypes[static_cast<int>(kind)], &cornersOf_));
    mesh_.forEachCell(kind,
      [this, region, section, &next](const Corners& cell, std::size_t ofCell)
      {
        if (ofCell != region)
        {
          return;
        }
        addPoints(cell);
        if (points_.size() >= static_cast<std::size_t>(Block))
        {
          flush(section, next);
        }
      });
    flush(section, next);
  }

  // A section of one kind of faces, or one of both.
  void writeFaces(const BoundaryPatch& patch, const std::string& label)
  {
    const bool mixed = patch.triangles > 0 && patch.quadrilaterals > 0;
    const auto single = patch.triangles > 0 ? CGNS_ENUMV(TRI_3) : CGNS_ENUMV(QUAD_4);
    std::vector<cgsize_t> starts = { 0 };
    for (vtkIdType f = patch.first; f < patch.first + patch.count(); ++f)
    {
      const Corners face = mesh_.face(f);
      if (mixed)
      {
        points_.push_back(ElementTypes[static_cast<int>(face.kind)]);
      }
      addPoints(face);
      if (mixed)
      {
        starts.push_back(number(static_cast<vtkIdType>(points_.size())));
      }
    }
    int section = 0;
    const cgsize_t first = elements_ + 1;
    elements_ += number(patch.count());
    check(mixed ? cg_poly_section_write(file_, base_, zone_, label.c_str(), CGNS_ENUMV(MIXED), first,
                    elements_, 0, points_.data(), starts.data(), &section)
                : cg_section_write(file_, base_, zone_, label.c_str(), single, first, elements_, 0,
                    points_.data(), &section));
    points_.clear();
  }

  void writePatch(const BoundaryPatch& patch, const std::string& label)
  {
    const cgsize_t range[2] = { elements_ + 1, elements_ + number(patch.count()) };
    writeFaces(patch, label);
    int family = 0;
    check(cg_family_write(file_, base_, label.c_str(), &family));
    check(cg_goto(file_, base_, "Family_t", family, "end"));
    check(cg_descriptor_write("PatchType", std::string(nameOf(patch.type)).c_str()));
    if (patch.inside)
    {
      return;
    }
    int condition = 0;
    check(cg_fambc_write(file_, base_, family, "FamBC", conditionFor(patch.type), &condition));
    check(cg_boco_write(file_, base_, zone_, label.c_str(), CGNS_ENUMV(FamilySpecified),
      CGNS_ENUMV(PointRange), 2, range, &condition));
    check(cg_boco_gridlocation_write(file_, base_, zone_, condition, CGNS_ENUMV(FaceCenter)));
    check(cg_goto(file_, base_, "Zone_t", zone_, "ZoneBC_t", 1, "BC_t", condition, "end"));
    check(cg_famname_write(label.c_str()));
  }

  const MeshView& mesh_;
  std::vector<std::string> labels_;
  std::vector<std::string> regionLabels_;
  std::vector<cgsize_t> points_;
  int cornersOf_ = 0; // of the section's elements
  cgsize_t elements_ = 0;
  int file_ = 0;
  int base_ = 0;
  int zone_ = 0;
  bool open_ = false;
};

// More than the file takes.
long long largestSize(const MeshView& mesh)
{
  constexpr long long forNodes = 1 << 14; // of the tree that a CGNS file is
  long long size =
    (20 + 6 * static_cast<long long>(mesh.patches().size() + 2 * mesh.regions().size())) * forNodes;
  size += mesh.numberOfPoints() * 3 * static_cast<long long>(sizeof(double));
  constexpr std::array<int, 4> corners = { 4, 5, 6, 8 };
  for (const CellKind kind : VolumeKinds)
  {
    size +=
      mesh.numberOfCells(kind) * corners[static_cast<int>(kind)] * static_cast<long long>(sizeof(cgsize_t));
  }
  return size + mesh.numberOfFaces() * 6 * static_cast<long long>(sizeof(cgsize_t));
}

// Makes sure that a file of that size can be made: HDF5 does not survive a disk that turns out to be full (a file
// that it could not close crashes the process when it ends). The system's number of the error, or 0.
int reserve(const std::string& path, long long size)
{
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0)
  {
    return errno;
  }
  int error = ::fallocate(file, 0, 0, size) < 0 ? errno : 0;
  if (error == EOPNOTSUPP) // the file system cannot tell
  {
    error = 0;
  }
  ::close(file);
  return error;
}

Outcome refuseUnheld(const MeshView& mesh)
{
  constexpr vtkIdType most = std::numeric_limits<cgsize_t>::max();
  if (mesh.numberOfCells() >= most / 8 || mesh.numberOfPoints() >= most)
  {
    return Outcome::badInput("the mesh has too many cells for the numbers that libcgns was built with");
  }
  for (const BoundaryPatch& patch : mesh.patches())
  {
    if (patch.inside && patch.type == PatchType::Wall)
    {
      return Outcome::badInput("patch " + patch.name +
        " is a wall without thickness, which a CGNS file cannot hold as a boundary: write a polyMesh or "
        ".msh");
    }
  }
  return Outcome::done();
}
} // namespace

Outcome vtkCGNSMeshWriter::WriteMesh(const MeshView& mesh)
{
  ReplacedPath path(this->FileName, ReplacedPath::Kind::File);
  for (const Outcome& outcome : { refuseUnheld(mesh), path.prepare() })
  {
    if (!outcome.ok())
    {
      return outcome;
    }
  }
  if (const int error = reserve(path.temporary(), largestSize(mesh)))
  {
    return writingFailed(this->FileName, error);
  }
  try
  {
    CGNSFile(mesh, path.temporary()).write();
  }
  catch (const std::runtime_error& error)
  {
    return Outcome::badInput(std::string(this->FileName) + ": could not be written: " + error.what());
  }
  return path.commit();
}
