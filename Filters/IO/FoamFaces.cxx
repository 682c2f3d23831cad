#include "FoamFaces.h"

namespace ransmesh::foam
{
// Text: a list of faces. Binary: a list of where each face's points begin, then one of all faces' points; as both
// lengths are known beforehand, they are written side by side.
class FoamFaces::FaceFile
{
public:
  FaceFile(const std::string& path, bool binary, vtkIdType faces, vtkIdType points)
    : file_(path)
    , binary_(binary)
  {
    file_.text(header("faces", binary ? "faceCompactList" : "faceList", binary));
    if (!binary)
    {
      file_.number(faces).text("\n(\n");
      return;
    }
    starts_ = std::make_unique<LabelList>(file_, true, faces + 1);
    starts_->add(0);
    const long long end = file_.position() + static_cast<long long>(faces * sizeof(std::int32_t)) + 2;
    pointsFile_ = std::make_unique<OutputFile>(path, OutputFile::Mode::At, end);
    points_ = std::make_unique<LabelList>(*pointsFile_, true, points);
  }

  void add(const Face& face)
  {
    if (binary_)
    {
      written_ += face.count;
      starts_->add(written_);
      std::for_each(face.begin(), face.end(), [this](vtkIdType p) { points_->add(p); });
      return;
    }
    file_.number(face.count);
    for (int i = 0; i < face.count; ++i)
    {
      file_.text(i == 0 ? "(" : " ").number(face.points[i]);
    }
    file_.text(")\n");
  }

  int close()
  {
    if (binary_)
    {
      starts_->end();
      points_->end();
      pointsFile_->close();
    }
    else
    {
      file_.text(")\n");
    }
    file_.close();
    return file_.error() != 0 || !binary_ ? file_.error() : pointsFile_->error();
  }

private:
  OutputFile file_;
  std::unique_ptr<OutputFile> pointsFile_;
  std::unique_ptr<LabelList> starts_;
  std::unique_ptr<LabelList> points_;
  vtkIdType written_ = 0;
  bool binary_;
};

FoamFaces::FoamFaces(const MeshView& mesh, const std::string& folder, bool binary)
  : mesh_(mesh)
  , order_(mesh)
  , folder_(folder + "/")
  , binary_(binary)
{
}

// The three files, and the lists in them.
struct FoamFaces::Files
{
  Files(const std::string& folder, bool binary, const std::string& note, const Counts& counts)
    : faces(folder + "faces", binary, counts.faces, counts.points)
    , owner(folder + "owner")
    , neighbour(folder + "neighbour")
    , owners(begin(owner, "owner", binary, note), binary, counts.faces)
    , neighbours(begin(neighbour, "neighbour", binary, note), binary, counts.internal)
  {
  }

  static OutputFile& begin(OutputFile& file, const char* name, bool binary, const std::string& note)
  {
    return file.text(header(name, "labelList", binary, note));
  }

  // The system's number of the first error, or 0.
  int close()
  {
    owners.end();
    neighbours.end();
    owner.close();
    neighbour.close();
    const int error = faces.close();
    return error != 0 ? error : owner.error() != 0 ? owner.error() : neighbour.error();
  }

  FaceFile faces;
  OutputFile owner;
  OutputFile neighbour;
  LabelList owners;
  LabelList neighbours;
};

FoamFaces::Counts FoamFaces::count()
{
  Counts counts;
  counts.internal = order_.internalFaces(3) + order_.internalFaces(4);
  counts.faces = counts.internal;
  counts.points = 3 * order_.internalFaces(3) + 4 * order_.internalFaces(4);
  for (const BoundaryPatch& patch : mesh_.patches())
  {
    starts_.push_back(counts.faces);
    counts.faces += order_.outerFaces(patch);
    counts.points += FaceOrder::sidesOf(patch) * (3 * patch.triangles + 4 * patch.quadrilaterals);
  }
  return counts;
}

Outcome FoamFaces::write()
{
  const Counts counts = count();
  const std::string note = "nPoints:" + std::to_string(mesh_.numberOfPoints()) +
    "  nCells:" + std::to_string(mesh_.numberOfCells()) + "  nFaces:" + std::to_string(counts.faces) +
    "  nInternalFaces:" + std::to_string(counts.internal);
  Files files(folder_, binary_, note, counts);
  vtkIdType label = 0;
  const Outcome outcome = order_.forEachInternalFace(
    [this, &files, &label](const FaceOrder::InternalFace& face)
    {
      files.faces.add(face.face);
      files.owners.add(face.owner);
      files.neighbours.add(face.neighbour);
      if (face.sheetFace >= 0)
      {
        addZoneFace(face, label);
      }
      ++label;
    });
  if (outcome.ok())
  {
    writeOuterFaces(files);
    error_ = files.close();
  }
  return outcome;
}

void FoamFaces::writeOuterFaces(Files& files)
{
  for (const BoundaryPatch& patch : mesh_.patches())
  {
    for (int side = 0; side < FaceOrder::sidesOf(patch); ++side)
    {
      for (vtkIdType f = patch.first; f < patch.first + patch.count(); ++f)
      {
        const FaceOrder::OuterFace outer = order_.outerFace(f, side);
        files.faces.add(outer.face);
        files.owners.add(outer.owner);
      }
    }
  }
}

void FoamFaces::addZoneFace(const FaceOrder::InternalFace& face, vtkIdType label)
{
  const Corners own = mesh_.face(face.sheetFace);
  const auto* at = std::find(own.begin(), own.end(), face.face.points[0]);
  const vtkIdType next = own[static_cast<int>(at - own.begin() + 1) % own.count];
  zoneFaces_.push_back({ label, face.sheetFace, next != face.face.points[1] });
}
} // namespace ransmesh::foam
