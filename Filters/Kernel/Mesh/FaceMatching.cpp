#include "Mesh/FaceMatching.h"

#include "Mesh/TetMesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>

namespace ransmesh
{
namespace
{
std::array<Index, 3> sorted(std::array<Index, 3> f)
{
  if (f[0] > f[1])
  {
    std::swap(f[0], f[1]);
  }
  if (f[1] > f[2])
  {
    std::swap(f[1], f[2]);
  }
  if (f[0] > f[1])
  {
    std::swap(f[0], f[1]);
  }
  return f;
}

std::array<Index, 3> faceOfTet(const std::array<Index, 4>& tet, int f)
{
  return { tet[FaceCorners[f][0]], tet[FaceCorners[f][1]], tet[FaceCorners[f][2]] };
}

// All faces and triangles in buckets by their smallest vertex: a bucket holds few, so that sorting each
// is cheap, and takes the place of a hash table of all faces.
class FaceBuckets
{
public:
  struct Entry
  {
    std::uint64_t others; // the middle and the largest vertex
    std::uint32_t code;   // a face 4 * t + f, or -(triangle + 1): triangles come after tetrahedra

    Index signedCode() const { return static_cast<Index>(code); }
    bool operator<(const Entry& b) const { return others != b.others ? others < b.others : code < b.code; }
  };

  explicit FaceBuckets(const MeshData& mesh)
    : start_(mesh.points.size() + 1, 0)
  {
    forEach(mesh, [this](const std::array<Index, 3>& f, Index) { ++start_[f[0] + 1]; });
    for (std::size_t i = 1; i < start_.size(); ++i)
    {
      start_[i] += start_[i - 1];
    }
    entries_.resize(start_.back());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    forEach(mesh,
      [&](const std::array<Index, 3>& f, Index code)
      {
        const auto others = static_cast<std::uint64_t>(f[1]) << 32 | static_cast<std::uint64_t>(f[2]);
        entries_[next[f[0]]++] = { others, static_cast<std::uint32_t>(code) };
      });
  }
  std::size_t count() const { return start_.size() - 1; }
  // The entries of one bucket, equal faces side by side, tetrahedra before triangles.
  const Entry* sortedBegin(std::size_t bucket)
  {
    std::sort(entries_.data() + start_[bucket], entries_.data() + start_[bucket + 1]);
    return entries_.data() + start_[bucket];
  }
  const Entry* end(std::size_t bucket) const { return entries_.data() + start_[bucket + 1]; }

private:
  template <class Visit>
  static void forEach(const MeshData& mesh, Visit visit)
  {
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    {
      for (int f = 0; f < 4; ++f)
      {
        visit(sorted(faceOfTet(mesh.tetrahedra[t], f)), halfFace(static_cast<Index>(t), f));
      }
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      visit(sorted(mesh.triangles[i]), boundaryHalfFace(static_cast<Index>(i)));
    }
  }

  std::vector<std::size_t> start_;
  std::vector<Entry> entries_;
};

void noteFirst(Index& first, Index candidate)
{
  first = first == None ? candidate : std::min(first, candidate);
}

// One face: its tetrahedra [begin, split), its triangles [split, end).
void matchOneFace(const FaceBuckets::Entry* begin, const FaceBuckets::Entry* split,
  const FaceBuckets::Entry* end, FaceMatching& result)
{
  const auto tets = split - begin;
  const auto triangles = end - split;
  if (tets > 2)
  {
    ++result.facesInMoreThanTwoTets;
    noteFirst(result.firstFaultyTet, tetOf(begin->signedCode()));
  }
  if (tets == 2)
  {
    result.opposite[begin[0].code] = begin[1].signedCode();
    result.opposite[begin[1].code] = begin[0].signedCode();
  }
  if (tets == 1 && triangles >= 1)
  {
    result.opposite[begin->code] = split->signedCode();
  }
  if (tets == 1 && triangles == 0)
  {
    ++result.facesWithoutTriangle;
    noteFirst(result.firstFaultyTet, tetOf(begin->signedCode()));
  }
  if (triangles > 1)
  {
    ++result.repeatedTriangles;
    noteFirst(result.firstFaultyTriangle, boundaryFaceOf(split->signedCode()));
  }
  if (tets == 2 && triangles > 0)
  {
    result.sheets.push_back({ boundaryFaceOf(split->signedCode()), begin->signedCode() });
  }
  else if (tets != 1 && triangles > 0)
  {
    ++result.trianglesOffTheBoundary;
    noteFirst(result.firstFaultyTriangle, boundaryFaceOf(split->signedCode()));
  }
}

// A patch is a sheet or a part of the boundary: triangles inside the mesh are wrong where others of their
// patch lie on the boundary.
void refuseMixedPatches(const MeshData& mesh, FaceMatching& result)
{
  if (result.sheets.empty())
  {
    return;
  }
  std::vector<char> isInside(mesh.triangles.size(), 0);
  for (const SheetFace& sheet : result.sheets)
  {
    isInside[sheet.triangle] = 1;
  }
  std::set<int> boundaryPatches;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (!isInside[i])
    {
      boundaryPatches.insert(mesh.trianglePatch[i]);
    }
  }
  std::erase_if(result.sheets,
    [&](const SheetFace& sheet)
    {
      const bool mixed = boundaryPatches.contains(mesh.trianglePatch[sheet.triangle]);
      if (mixed)
      {
        ++result.trianglesOffTheBoundary;
        noteFirst(result.firstFaultyTriangle, sheet.triangle);
      }
      return mixed;
    });
}
} // namespace

FaceMatching matchFaces(const MeshData& mesh)
{
  FaceMatching result;
  result.opposite.assign(4 * mesh.tetrahedra.size(), FaceMatching::Unmatched);
  FaceBuckets buckets(mesh);
  for (std::size_t bucket = 0; bucket < buckets.count(); ++bucket)
  {
    const FaceBuckets::Entry* begin = buckets.sortedBegin(bucket);
    const FaceBuckets::Entry* end = buckets.end(bucket);
    while (begin != end)
    {
      const FaceBuckets::Entry* next = begin;
      while (next != end && next->others == begin->others)
      {
        ++next;
      }
      const FaceBuckets::Entry* split =
        std::find_if(begin, next, [](const FaceBuckets::Entry& e) { return isBoundary(e.signedCode()); });
      matchOneFace(begin, split, next, result);
      begin = next;
    }
  }
  refuseMixedPatches(mesh, result);
  return result;
}
} // namespace ransmesh
