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

Outcome FoamFaces::write()
{
  const vtkIdType internal = order_.internalFaces(3) + order_.internalFaces(4);
  vtkIdType faces = internal;
  vtkIdType points = 3 * order_.internalFaces(3) + 4 * order_.internalFaces(4);
  for (const BoundaryPatch& patch : mesh_.patches())
  {
    starts_.push_back(faces);
    faces += order_.outerFaces(patch);
    points += FaceOrder::sidesOf(patch) * (3 * patch.triangles + 4 * patch.quadrilaterals);
  }
  const std::string note = "nPoints:" + std::to_string(mesh_.numberOfPoints()) +
    "  nCells:" + std::to_string(mesh_.numberOfCells()) + "  nFaces:" + std::to_string(faces) +
    "  nInternalFaces:" + std::to_string(internal);
  FaceFile faceFile(folder_ + "faces", binary_, faces, points);
  OutputFile ownerFile(folder_ + "owner");
  OutputFile neighbourFile(folder_ + "neighbour");
  ownerFile.text(header("owner", "labelList", binary_, note));
  neighbourFile.text(header("neighbour", "labelList", binary_, note));
  LabelList owners(ownerFile, binary_, faces);
  LabelList neighbours(neighbourFile, binary_, internal);
  vtkIdType label = 0;
  const Outcome outcome = order_.forEachInternalFace(
    [&](const FaceOrder::InternalFace& face)
    {
      faceFile.add(face.face);
      owners.add(face.owner);
      neighbours.add(face.neighbour);
      if (face.sheetFace >= 0)
      {
        zoneFaces_.push_back({ label, face.sheetFace, false });
        addZoneFace(face);
      }
      ++label;
    });
  if (!outcome.ok())
  {
    return outcome;
  }
  for (const BoundaryPatch& patch : mesh_.patches())
  {
    for (int side = 0; side < FaceOrder::sidesOf(patch); ++side)
    {
      for (vtkIdType f = patch.first; f < patch.first + patch.count(); ++f)
      {
        const FaceOrder::OuterFace outer = order_.outerFace(f, side);
        faceFile.add(outer.face);
        owners.add(outer.owner);
      }
    }
  }
  owners.end();
  neighbours.end();
  ownerFile.close();
  neighbourFile.close();
  for (const int error : { faceFile.close(), ownerFile.error(), neighbourFile.error() })
  {
    error_ = error_ ? error_ : error;
  }
  return Outcome::done();
}

void FoamFaces::addZoneFace(const FaceOrder::InternalFace& face)
{
  const Corners own = mesh_.face(face.sheetFace);
  const auto* at = std::find(own.begin(), own.end(), face.face.points[0]);
  const vtkIdType next = own[static_cast<int>(at - own.begin() + 1) % own.count];
  zoneFaces_.back().flipped = next != face.face.points[1];
}
} // namespace ransmesh::foam
