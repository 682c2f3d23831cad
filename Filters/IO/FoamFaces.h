// The files faces, owner and neighbour of a polyMesh folder, written side by side.
#ifndef FoamFaces_h
#define FoamFaces_h

#include "FaceOrder.h"
#include "FoamFile.h"

#include <memory>
#include <string>
#include <vector>

namespace ransmesh::foam
{
// A face of a sheet that is inside the mesh.
struct ZoneFace
{
  vtkIdType label;    // its number in the file
  vtkIdType viewFace; // the view's
  bool flipped;       // the view's face is turned from the neighbour to the owner
};

class FoamFaces
{
public:
  FoamFaces(const MeshView& mesh, const std::string& folder, bool binary);

  // BadInput if the mesh is not conforming. The files' errors: error().
  Outcome write();
  int error() const { return error_; }

  // The first face of a patch, and the faces of sheets, by the view's numbers; after write.
  vtkIdType startOf(std::size_t patch) const { return starts_[patch]; }
  const std::vector<ZoneFace>& zoneFaces() const { return zoneFaces_; }
  const FaceOrder& order() const { return order_; }

private:
  class FaceFile; // text, or binary
  struct Files;
  struct Counts
  {
    vtkIdType internal = 0; // faces
    vtkIdType faces = 0;
    vtkIdType points = 0; // of all faces
  };
  Counts count();
  void writeOuterFaces(Files& files);
  void addZoneFace(const FaceOrder::InternalFace& face, vtkIdType label);

  const MeshView& mesh_;
  FaceOrder order_;
  std::string folder_;
  bool binary_;
  int error_ = 0;
  std::vector<vtkIdType> starts_;
  std::vector<ZoneFace> zoneFaces_;
};
} // namespace ransmesh::foam

#endif
