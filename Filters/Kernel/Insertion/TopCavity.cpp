#include "Insertion/TopCavity.h"

#include <algorithm>
#include <limits>

namespace ransmesh
{
void TopCavity::begin(std::span<const Index> seed, const Vector3& near)
{
  near_ = near;
  inSeed_.clear();
  inGrown_.clear();
  faces_.clear();
  cavity_.tets.assign(seed.begin(), seed.end());
  seedTets_ = seed.size();
  for (const Index t : seed)
  {
    inSeed_.set(t);
  }
  for (const Index t : seed)
  {
    addFaces(t);
  }
  std::partition(faces_.begin(), faces_.end(), [](const Face& face) { return isBoundary(face.beyond); });
  seedFaces_ = faces_.size();
}

// The faces of the tetrahedron that are outer ones.
void TopCavity::addFaces(Index tet)
{
  const Tetrahedron& here = mesh_.tet(tet);
  for (int f = 0; f < 4; ++f)
  {
    const HalfFace beyond = here.neighbour[f];
    if (isBoundary(beyond) || !(inSeed_.test(tetOf(beyond)) || isGrown(beyond)))
    {
      faces_.push_back({ here.face(f), beyond, false });
    }
  }
}

// Many faces are never asked: they have the apex, or others refuse before them.
const FaceView& TopCavity::viewOf(std::size_t face)
{
  views_.resize(std::max(views_.size(), faces_.size()));
  if (!faces_[face].isReady)
  {
    const auto& v = faces_[face].vertex;
    views_[face] = FaceView(mesh_.point(v[0]) - near_, mesh_.point(v[1]) - near_, mesh_.point(v[2]) - near_);
    faces_[face].isReady = true;
  }
  return views_[face];
}

void TopCavity::undoGrowth()
{
  inGrown_.clear();
  faces_.resize(seedFaces_);
  cavity_.tets.resize(seedTets_);
  cavity_.starredFaces.clear();
  square_.clear();
}

bool TopCavity::goes(const Face& face, const Column* ofSides) const
{
  return ofSides && isBoundary(face.beyond) && ofSides->staysIn(mesh_.patchOf(face.beyond));
}

bool TopCavity::grow(Index apex, double wanted, std::size_t largest, const Column* ofSides)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  undoGrowth();
  const Vector3 place = mesh_.point(apex) - near_;
  const double squareOfApex = dot(place, place);
  const double wantedSquare = wanted * std::fabs(wanted);
  // They become more as the loop goes.
  for (std::size_t i = 0; i < faces_.size(); ++i) // NOLINT(modernize-loop-convert)
  {
    const HalfFace beyond = faces_[i].beyond;
    square_.push_back(none);
    if (isGrown(beyond))
    {
      continue;
    }
    if (goes(faces_[i], ofSides))
    {
      cavity_.starredFaces.push_back(boundaryFaceOf(beyond));
      continue;
    }
    if (faces_[i].has(apex))
    {
      continue;
    }
    square_.back() = viewOf(i).signedSquare(place, squareOfApex);
    if (square_.back() > wantedSquare)
    {
      continue;
    }
    if (isBoundary(beyond) || cavity_.tets.size() >= largest)
    {
      return false;
    }
    inGrown_.set(tetOf(beyond));
    cavity_.tets.push_back(tetOf(beyond));
    addFaces(tetOf(beyond));
  }
  double worst = none;
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    worst = isGrown(faces_[i].beyond) ? worst : std::min(worst, square_[i]);
  }
  worst_ = signedRoot(worst);
  return worst < none;
}
} // namespace ransmesh
