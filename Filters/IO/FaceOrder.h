// All faces of a mesh, each once, in the order of OpenFOAM: internal faces by owner, then by neighbour (the owner
// is the cell of the lower number), with little memory.
//
// Cells are taken in parts. The faces of a part's cells are matched with each other and with the faces of all
// later cells; what is needed for that is there for one part only.
#ifndef FaceOrder_h
#define FaceOrder_h

#include "FaceChains.h"

#include <functional>
#include <vector>

namespace ransmesh
{
class FaceOrder
{
public:
  // A sheet whose type is wall is outer boundary, on both its sides; other sheets are internal faces.
  explicit FaceOrder(const MeshView& mesh);

  // Known before any face is enumerated, if the mesh is conforming. Count only those with so many corners, 3 or 4.
  vtkIdType internalFaces(int corners) const;
  vtkIdType outerFaces(const BoundaryPatch& patch) const { return patch.count() * sidesOf(patch); }
  static int sidesOf(const BoundaryPatch& patch)
  {
    return !patch.inside ? 1 : patch.type == PatchType::Wall ? 2 : 0;
  }

  // face: its normal points from the owner to the neighbour. sheetFace: the view's number of it, or -1.
  struct InternalFace
  {
    Face face;
    vtkIdType owner;
    vtkIdType neighbour;
    vtkIdType sheetFace;
  };
  // BadInput if the mesh is not conforming. To be called once, before outerFace.
  Outcome forEachInternalFace(const std::function<void(const InternalFace&)>& act);

  struct OuterFace
  {
    Face face;
    vtkIdType owner;
  };
  // One of the view's boundary faces, of a patch with sides.
  OuterFace outerFace(vtkIdType viewFace, int side) const;

private:
  struct Part // cells first to last - 1
  {
    vtkIdType first;
    vtkIdType last;
  };

  void enterBoundary();
  std::uint32_t boundaryFaceOf(const FaceKey& key) const;
  bool takenByBoundary(const FaceKey& key, vtkIdType cell);
  void matchWithin(const Part& part);
  void markOpen(const Part& part);
  void matchLater(const Part& part);
  void emit(const Part& part, const std::function<void(const InternalFace&)>& act);
  Outcome checkComplete() const;

  const MeshView& mesh_;
  std::uint32_t stride_ = 4;                         // half-faces a cell
  std::vector<unsigned char> sides_;                 // by the view's boundary faces
  std::vector<std::array<std::uint32_t, 2>> owners_; // of the boundary faces, on either side
  FaceChains boundary_;
  bool hasSheets_ = false;                // that are internal faces
  FaceChains halfFaces_;                  // of the part, unmatched
  std::vector<std::uint32_t> neighbours_; // of the part's half-faces
  std::vector<bool> open_;                // points of the part's unmatched half-faces
  vtkIdType emitted_ = 0;
};
} // namespace ransmesh

#endif
