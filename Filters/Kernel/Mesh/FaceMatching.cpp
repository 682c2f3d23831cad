#include "Mesh/FaceMatching.h"

#include "Mesh/TetMesh.h"
#include "Support/LargeMemory.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <set>
#include <utility>

namespace ransmesh
{
namespace
{
// A vertex or a corner with it: vertex numbers rank first, so that sorting vertices takes their corners along.
using Ranked = std::uint64_t;

Ranked ranked(Index vertex, int corner)
{
  return static_cast<Ranked>(vertex) << 2 | static_cast<Ranked>(corner);
}

Index vertexOf(Ranked r)
{
  return static_cast<Index>(r >> 2);
}

int cornerOf(Ranked r)
{
  return static_cast<int>(r & 3);
}

// Without branches: their outcome would be a toss.
void order(Ranked& a, Ranked& b)
{
  const Ranked low = std::min(a, b);
  b = std::max(a, b);
  a = low;
}

std::array<Ranked, 4> rankedCorners(const std::array<Index, 4>& tet)
{
  std::array<Ranked, 4> r = { ranked(tet[0], 0), ranked(tet[1], 1), ranked(tet[2], 2), ranked(tet[3], 3) };
  order(r[0], r[1]);
  order(r[2], r[3]);
  order(r[0], r[2]);
  order(r[1], r[3]);
  order(r[1], r[2]);
  return r;
}

std::pair<Index, Index> twoSmallest(const std::array<Index, 4>& tet)
{
  const Index low01 = std::min(tet[0], tet[1]);
  const Index low23 = std::min(tet[2], tet[3]);
  const Index high = std::min(std::max(tet[0], tet[1]), std::max(tet[2], tet[3]));
  return { std::min(low01, low23), std::min(std::max(low01, low23), high) };
}

std::array<Index, 3> sortedCorners(std::array<Index, 3> f)
{
  std::sort(f.begin(), f.end());
  return f;
}

// All faces and triangles in buckets by their smallest vertex: a bucket holds few, so that finding equal ones
// in it is cheap, and takes the place of a hash table of all faces.
class FaceBuckets
{
public:
  struct Entry
  {
    Index middle;
    Index largest;
    std::uint32_t code; // a face 4 * t + f, or -(triangle + 1): triangles come after tetrahedra

    // The middle and the largest vertex.
    std::uint64_t others() const
    {
      return static_cast<std::uint64_t>(middle) << 32 | static_cast<std::uint64_t>(largest);
    }
    Index signedCode() const { return static_cast<Index>(code); }
    bool operator<(const Entry& b) const
    {
      return others() != b.others() ? others() < b.others() : code < b.code;
    }
  };

  explicit FaceBuckets(const MeshData& mesh)
    : start_(mesh.points.size() + 1, 0)
  {
    for (const auto& tet : mesh.tetrahedra)
    {
      const auto [least, second] = twoSmallest(tet);
      start_[least + 1] += 3;
      ++start_[second + 1];
    }
    for (const auto& triangle : mesh.triangles)
    {
      ++start_[*std::min_element(triangle.begin(), triangle.end()) + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    entries_ = std::make_unique_for_overwrite<Entry[]>(start_.back());
    preferLargePages(entries_.get(), start_.back() * sizeof(Entry));
    fill(mesh);
  }
  std::size_t count() const { return start_.size() - 1; }
  Entry* begin(std::size_t bucket) { return entries_.get() + start_[bucket]; }
  Entry* end(std::size_t bucket) { return entries_.get() + start_[bucket + 1]; }

private:
  void fill(const MeshData& mesh)
  {
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    const auto add = [&](Index bucket, Index middle, Index largest, Index code) {
      entries_[next[bucket]++] = { middle, largest, static_cast<std::uint32_t>(code) };
    };
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    {
      const auto r = rankedCorners(mesh.tetrahedra[t]);
      const Index v[4] = { vertexOf(r[0]), vertexOf(r[1]), vertexOf(r[2]), vertexOf(r[3]) };
      const auto opposite = [&](int i) { return halfFace(static_cast<Index>(t), cornerOf(r[i])); };
      add(v[0], v[1], v[2], opposite(3));
      add(v[0], v[1], v[3], opposite(2));
      add(v[0], v[2], v[3], opposite(1));
      add(v[1], v[2], v[3], opposite(0));
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      const auto v = sortedCorners(mesh.triangles[i]);
      add(v[0], v[1], v[2], boundaryHalfFace(static_cast<Index>(i)));
    }
  }

  std::vector<std::uint32_t> start_;
  std::unique_ptr<Entry[]> entries_;
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

// Finds equal faces by a small table; sorting each bucket instead takes three times as long.
class PairTable
{
public:
  // Pairs all entries of the bucket off. False, with nothing of use in result, where a face has not exactly two
  // entries, or two triangles, or where the bucket is too large for the table.
  bool match(const FaceBuckets::Entry* begin, const FaceBuckets::Entry* end, FaceMatching& result)
  {
    if (end - begin > static_cast<std::ptrdiff_t>(Size / 2))
    {
      return false;
    }
    ++bucket_;
    std::ptrdiff_t open = 0;
    for (const FaceBuckets::Entry* e = begin; e != end; ++e)
    {
      Slot& slot = find(e->others());
      if (slot.bucket != bucket_)
      {
        slot = { e->others(), e->code, bucket_ };
        ++open;
        continue;
      }
      if (slot.code == Paired || (isBoundary(e->signedCode()) && isBoundary(static_cast<Index>(slot.code))))
      {
        return false;
      }
      // Triangles come after tetrahedra: the slot's is one of the latter.
      result.opposite[slot.code] = e->signedCode();
      if (!isBoundary(e->signedCode()))
      {
        result.opposite[e->code] = static_cast<Index>(slot.code);
      }
      slot.code = Paired;
      --open;
    }
    return open == 0;
  }

private:
  static constexpr std::size_t Size = 512;
  static constexpr std::uint32_t Paired = static_cast<std::uint32_t>(FaceMatching::Unmatched);
  struct Slot
  {
    std::uint64_t others = 0;
    std::uint32_t code = 0;
    std::uint32_t bucket = 0; // that the slot was last used for
  };

  // The slot that holds these vertices, or the free one where they belong.
  Slot& find(std::uint64_t others)
  {
    std::size_t i = (others * 0x9e3779b97f4a7c15ULL) >> 55; // Fibonacci hashing to 9 bits
    while (slots_[i].bucket == bucket_ && slots_[i].others != others)
    {
      i = (i + 1) % Size;
    }
    return slots_[i];
  }

  std::array<Slot, Size> slots_;
  std::uint32_t bucket_ = 0;
};

// Sorts the bucket: equal faces side by side, tetrahedra before triangles.
void matchBySorting(FaceBuckets::Entry* begin, FaceBuckets::Entry* end, FaceMatching& result)
{
  for (const FaceBuckets::Entry* e = begin; e != end; ++e)
  {
    if (!isBoundary(e->signedCode()))
    {
      result.opposite[e->code] = FaceMatching::Unmatched;
    }
  }
  std::sort(begin, end);
  while (begin != end)
  {
    const FaceBuckets::Entry* next = begin;
    while (next != end && next->others() == begin->others())
    {
      ++next;
    }
    const FaceBuckets::Entry* split = std::find_if(static_cast<const FaceBuckets::Entry*>(begin), next,
      [](const FaceBuckets::Entry& e) { return isBoundary(e.signedCode()); });
    matchOneFace(begin, split, next, result);
    begin += next - begin;
  }
}
} // namespace

FaceMatching matchFaces(const MeshData& mesh)
{
  FaceMatching result;
  reserveLarge(result.opposite, 4 * mesh.tetrahedra.size());
  result.opposite.assign(4 * mesh.tetrahedra.size(), FaceMatching::Unmatched);
  FaceBuckets buckets(mesh);
  PairTable pairs;
  for (std::size_t bucket = 0; bucket < buckets.count(); ++bucket)
  {
    FaceBuckets::Entry* begin = buckets.begin(bucket);
    FaceBuckets::Entry* end = buckets.end(bucket);
    if (!pairs.match(begin, end, result))
    {
      matchBySorting(begin, end, result);
    }
  }
  refuseMixedPatches(mesh, result);
  return result;
}
} // namespace ransmesh
