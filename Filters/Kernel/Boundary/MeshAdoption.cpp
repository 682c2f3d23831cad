#include "Boundary/MeshAdoption.h"

#include "Geometry/Predicates.h"
#include "Mesh/Regions.h"
#include "Mesh/TetMesh.h"
#include "Mesh/Tidying.h"
#include "Mesh/Validation.h"
#include "Triangles/FeatureSplit.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace ransmesh
{
namespace
{
using Corners = std::array<Index, 3>;

Corners sorted(Corners corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

struct TetFace
{
  Corners key;    // sorted
  Corners turned; // as the tetrahedron has it, outward
  Index tet;
};

std::string counted(std::size_t n, const char* one, const char* many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

class Adoption
{
public:
  Adoption(MeshData& mesh, NamedRegions& regions, PatchTable& patches, std::vector<std::string>& remarks)
    : mesh_(mesh)
    , regions_(regions)
    , patches_(patches)
    , remarks_(remarks)
  {
  }

  Outcome run(double featureAngle)
  {
    if (Outcome outcome = checkNumbers(); !outcome.ok())
    {
      return outcome;
    }
    mergePoints();
    if (Outcome outcome = makePositive(); !outcome.ok())
    {
      return outcome;
    }
    listFaces();
    sortOutTriangles();
    partInnerTriangles();
    coverFacesBetweenRegions();
    coverOuterFaces(featureAngle);
    dropUnusedPoints(mesh_);
    turnOutward(mesh_, matchFaces(mesh_));
    sortByPatch(mesh_);
    if (const MeshFaults faults = findFaults(mesh_); !faults.none())
    {
      return Outcome::badInput("the mesh is not valid: " + faults.text() +
        "; make it anew, or mend it, in the program that it comes from");
    }
    regions_.of = regions_.of.empty() ? numberRegions(mesh_) : regions_.of;
    return Outcome::done();
  }

private:
  void note(std::size_t count, const char* one, const char* many)
  {
    if (count > 0)
    {
      remarks_.push_back(counted(count, one, many));
    }
  }

  Outcome checkNumbers() const
  {
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
    {
      if (!isFinite(mesh_.points[v]))
      {
        return Outcome::badInput("point " + std::to_string(v) + " of the mesh is not finite");
      }
    }
    const auto isKnown = [this](Index v)
    { return v >= 0 && static_cast<std::size_t>(v) < mesh_.points.size(); };
    const auto allKnown = [&](const auto& cell) { return std::all_of(cell.begin(), cell.end(), isKnown); };
    const bool good = std::all_of(mesh_.tetrahedra.begin(), mesh_.tetrahedra.end(), allKnown) &&
      std::all_of(mesh_.triangles.begin(), mesh_.triangles.end(), allKnown);
    return good ? Outcome::done() : Outcome::badInput("cells of the mesh name points that are not there");
  }

  void mergePoints()
  {
    std::vector<Index> order(mesh_.points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto place = [this](Index v)
    {
      const Vector3& p = mesh_.points[v];
      return std::tuple(p.x, p.y, p.z);
    };
    std::sort(order.begin(), order.end(),
      [&](Index v, Index w)
      { return std::tuple_cat(place(v), std::tuple(v)) < std::tuple_cat(place(w), std::tuple(w)); });
    std::vector<Index> first(mesh_.points.size());
    std::size_t merged = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const bool isSame = i > 0 && place(order[i]) == place(order[i - 1]);
      first[order[i]] = isSame ? first[order[i - 1]] : order[i];
      merged += isSame;
    }
    renumberCorners(first, mesh_);
    note(merged, "point lay on another and was merged with it",
      "points lay on others and were merged with them");
  }

  Outcome makePositive()
  {
    std::size_t turned = 0;
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t)
    {
      auto& v = mesh_.tetrahedra[t];
      const auto& p = mesh_.points;
      const auto sign = orientation(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
      if (sign == 0)
      {
        char where[160];
        std::snprintf(
          where, sizeof where, "tetrahedron %zu near (%.7g, %.7g, %.7g)", t, p[v[0]].x, p[v[0]].y, p[v[0]].z);
        return Outcome::badInput(std::string("the mesh is not valid: its ") + where +
          " has no volume; make it anew in the program that it comes from");
      }
      if (sign < 0)
      {
        std::swap(v[2], v[3]);
        ++turned;
      }
    }
    note(turned, "tetrahedron was turned over", "tetrahedra were turned over");
    return Outcome::done();
  }

  void listFaces()
  {
    faces_.reserve(4 * mesh_.tetrahedra.size());
    for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t)
    {
      const auto& tet = mesh_.tetrahedra[t];
      for (const auto& c : FaceCorners)
      {
        // The corners of a face run inward.
        const Corners turned = { tet[c[0]], tet[c[2]], tet[c[1]] };
        faces_.push_back({ sorted(turned), turned, static_cast<Index>(t) });
      }
    }
    std::sort(faces_.begin(), faces_.end(), [](const TetFace& a, const TetFace& b) { return a.key < b.key; });
  }

  // How many tetrahedra have the face.
  std::size_t tetsAt(const Corners& key) const
  {
    const auto less = [](const TetFace& a, const TetFace& b) { return a.key < b.key; };
    const auto [first, last] =
      std::equal_range(faces_.begin(), faces_.end(), TetFace{ key, key, None }, less);
    return last - first;
  }

  // Keeps what has a patch and is a face, once.
  void sortOutTriangles()
  {
    std::size_t stray = 0;
    std::size_t repeated = 0;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
    {
      const Corners key = sorted(mesh_.triangles[t]);
      const std::size_t tets = tetsAt(key);
      stray += tets == 0;
      if (tets == 0 || mesh_.trianglePatch[t] < 1)
      {
        continue;
      }
      if (!covered_.insert(key).second)
      {
        ++repeated;
        continue;
      }
      isInner_.push_back(tets > 1);
      mesh_.triangles[kept] = mesh_.triangles[t];
      mesh_.trianglePatch[kept++] = mesh_.trianglePatch[t];
    }
    mesh_.triangles.resize(kept);
    mesh_.trianglePatch.resize(kept);
    note(stray, "triangle is no face of a tetrahedron and was left out",
      "triangles are no faces of tetrahedra and were left out");
    note(repeated, "repeated triangle was left out", "repeated triangles were left out");
  }

  // A patch is on the boundary or inside, never both.
  void partInnerTriangles()
  {
    std::set<int> outer;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
    {
      if (!isInner_[t])
      {
        outer.insert(mesh_.trianglePatch[t]);
      }
    }
    std::map<int, int> innerOf;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
    {
      int& patch = mesh_.trianglePatch[t];
      if (!isInner_[t] || !outer.contains(patch))
      {
        continue;
      }
      const auto [inner, isNew] = innerOf.try_emplace(patch, static_cast<int>(patches_.size()));
      if (isNew)
      {
        remarks_.push_back("triangles of patch '" + patches_[patch].name +
          "' lie inside the mesh: they are the patch '" + patches_[patch].name + "_inside' now");
        patches_.push_back({ patches_[patch].name + "_inside", PatchType::Interface });
      }
      patch = inner->second;
    }
  }

  std::string nameOfRegion(int number) const
  {
    const auto name = regions_.name.find(number);
    return name == regions_.name.end() ? "region_" + std::to_string(number) : name->second;
  }

  void coverFacesBetweenRegions()
  {
    std::size_t added = 0;
    std::map<std::pair<int, int>, int> patchOf;
    for (std::size_t f = 1; f < faces_.size() && !regions_.of.empty(); ++f)
    {
      const auto [low, high] = std::minmax(regions_.of[faces_[f - 1].tet], regions_.of[faces_[f].tet]);
      if (faces_[f - 1].key != faces_[f].key || low == high || covered_.contains(faces_[f].key))
      {
        continue;
      }
      const auto [patch, isNew] = patchOf.try_emplace({ low, high }, static_cast<int>(patches_.size()));
      if (isNew)
      {
        patches_.push_back({ nameOfRegion(low) + "_to_" + nameOfRegion(high), PatchType::Interface });
      }
      mesh_.triangles.push_back(faces_[f].turned);
      mesh_.trianglePatch.push_back(patch->second);
      ++added;
    }
    note(added, "face between regions came without a patch and is of a patch '..._to_...' now",
      "faces between regions came without a patch and are of patches '..._to_...' now");
  }

  void coverOuterFaces(double featureAngle)
  {
    SurfaceMesh bare;
    for (std::size_t f = 0; f < faces_.size(); ++f)
    {
      const bool isOuter = (f == 0 || faces_[f - 1].key != faces_[f].key) &&
        (f + 1 == faces_.size() || faces_[f + 1].key != faces_[f].key);
      if (isOuter && !covered_.contains(faces_[f].key))
      {
        bare.triangles.push_back(faces_[f].turned);
      }
    }
    if (bare.triangles.empty())
    {
      return;
    }
    const auto patch = static_cast<int>(patches_.size());
    patches_.push_back({ "boundary", PatchType::Patch });
    bare.points = mesh_.points;
    bare.patch.assign(bare.triangles.size(), patch);
    if (featureAngle < 180)
    {
      splitByAngle(bare, patches_, patch, featureAngle);
    }
    mesh_.triangles.insert(mesh_.triangles.end(), bare.triangles.begin(), bare.triangles.end());
    mesh_.trianglePatch.insert(mesh_.trianglePatch.end(), bare.patch.begin(), bare.patch.end());
    note(bare.triangles.size(), "outer face came without a patch and is of patch 'boundary' now",
      "outer faces came without a patch and are of patches 'boundary...' now");
  }

  MeshData& mesh_;
  NamedRegions& regions_;
  PatchTable& patches_;
  std::vector<std::string>& remarks_;
  std::vector<TetFace> faces_;
  std::set<Corners> covered_; // faces that have a triangle
  std::vector<char> isInner_; // of each triangle
};
} // namespace

Outcome adoptMesh(MeshData& mesh, NamedRegions& regions, PatchTable& patches, double featureAngle,
  std::vector<std::string>& remarks)
{
  if (mesh.tetrahedra.empty())
  {
    return Outcome::badInput("the mesh has no tetrahedra");
  }
  return Adoption(mesh, regions, patches, remarks).run(featureAngle);
}
} // namespace ransmesh
