#include "Boundary/SheetDivision.h"

#include "Geometry/Predicates.h"

#include <algorithm>
#include <iterator>

namespace ransmesh
{
namespace
{
// The tetrahedra that have all points of the joint.
std::vector<Index> tetsAtJoint(const MeshData& mesh, const SheetJoint& joint, const SheetSides& sides)
{
  std::vector<Index> tets;
  const auto has = [](const auto& tet, Index v)
  { return v == None || std::find(tet.begin(), tet.end(), v) != tet.end(); };
  for (const Index t : sides.tetsAt(joint.vertex[0]))
  {
    const auto& tet = mesh.tetrahedra[t];
    if (has(tet, joint.vertex[1]) && has(tet, joint.vertex[2]))
    {
      tets.push_back(t);
    }
  }
  return tets;
}

// Finds the joints around one sheet triangle after the other.
class JointFinder
{
public:
  JointFinder(const MeshData& mesh, const std::vector<SheetTriangle>& sheets, const SheetSides& sides)
    : mesh_(mesh)
    , sheets_(sheets)
    , sides_(sides)
    , isTaken_(mesh.tetrahedra.size(), 0)
  {
    for (const SheetTriangle& sheet : sheets)
    {
      sheetFaces_.insert(sheetFaces_.end(), sheet.face.begin(), sheet.face.end());
    }
    std::sort(sheetFaces_.begin(), sheetFaces_.end());
  }

  std::vector<SheetJoint> run()
  {
    for (const SheetTriangle& sheet : sheets_)
    {
      const auto& v = mesh_.triangles[sheet.triangle];
      for (int i = 0; i < 3; ++i)
      {
        const Index a = v[i];
        const Index b = v[(i + 1) % 3];
        if (staysOne(sheet, a) && staysOne(sheet, b) && !goesRound(sheet, a, b))
        {
          edgeFound_ = true;
          take({ { std::min(a, b), std::max(a, b), None } });
        }
      }
    }
    for (std::size_t i = 0; i < sheets_.size() && !edgeFound_; ++i)
    {
      const auto& v = mesh_.triangles[sheets_[i].triangle];
      if (std::all_of(v.begin(), v.end(), [&](Index p) { return staysOne(sheets_[i], p); }))
      {
        take({ v });
      }
    }
    return std::move(joints_);
  }

private:
  bool staysOne(const SheetTriangle& sheet, Index v) const
  {
    return sides_.partOf(v, tetOf(sheet.face[0])) == sides_.partOf(v, tetOf(sheet.face[1]));
  }

  // Does one get from one side of the triangle to the other around the edge, through no sheet? At free
  // borders one does.
  bool goesRound(const SheetTriangle& sheet, Index a, Index b) const
  {
    HalfFace h = sheet.face[0];
    for (;;)
    {
      const auto& tet = mesh_.tetrahedra[tetOf(h)];
      int beyond = 0; // the other face at the edge is opposite to the face's third point
      while (tet[beyond] == a || tet[beyond] == b || beyond == faceOf(h))
      {
        ++beyond;
      }
      const HalfFace out = halfFace(tetOf(h), beyond);
      if (std::binary_search(sheetFaces_.begin(), sheetFaces_.end(), out))
      {
        return out == sheet.face[1];
      }
      h = otherSide(out, a);
      if (h == None)
      {
        return false;
      }
    }
  }

  HalfFace otherSide(HalfFace h, Index v) const
  {
    std::array<Index, 3> face = faceOfTet(h);
    for (const Index t : sides_.tetsAt(v))
    {
      for (int f = 0; f < 4 && t != tetOf(h); ++f)
      {
        if (faceOfTet(halfFace(t, f)) == face)
        {
          return halfFace(t, f);
        }
      }
    }
    return None;
  }

  std::array<Index, 3> faceOfTet(HalfFace h) const
  {
    const auto& tet = mesh_.tetrahedra[tetOf(h)];
    const int* corner = FaceCorners[faceOf(h)];
    std::array<Index, 3> face = { tet[corner[0]], tet[corner[1]], tet[corner[2]] };
    std::sort(face.begin(), face.end());
    return face;
  }

  void take(const SheetJoint& joint)
  {
    const std::vector<Index> tets = tetsAtJoint(mesh_, joint, sides_);
    if (std::any_of(tets.begin(), tets.end(), [this](Index t) { return isTaken_[t] != 0; }))
    {
      return;
    }
    for (const Index t : tets)
    {
      isTaken_[t] = 1;
    }
    joints_.push_back(joint);
  }

  const MeshData& mesh_;
  const std::vector<SheetTriangle>& sheets_;
  const SheetSides& sides_;
  std::vector<HalfFace> sheetFaces_;
  std::vector<char> isTaken_;
  bool edgeFound_ = false;
  std::vector<SheetJoint> joints_;
};

// The cells that a cell with all points of the joint becomes: one for each of these points, which gives way
// to the new one.
template <std::size_t N>
std::vector<std::array<Index, N>> divided(
  const std::array<Index, N>& cell, const SheetJoint& joint, Index middle)
{
  std::vector<std::array<Index, N>> parts;
  for (const Index v : joint.vertex)
  {
    if (v != None)
    {
      parts.push_back(cell);
      std::replace(parts.back().begin(), parts.back().end(), v, middle);
    }
  }
  return parts;
}

class Division
{
public:
  Division(MeshData& mesh, const SheetSides& sides)
    : mesh_(mesh)
    , sides_(sides)
  {
  }

  bool divide(const SheetJoint& joint)
  {
    const std::vector<Index> tets = tetsAtJoint(mesh_, joint, sides_);
    const auto middle = static_cast<Index>(mesh_.points.size());
    mesh_.points.emplace_back();
    for (const double share : { 0.5, 0.4, 0.6, 0.3, 0.7 })
    {
      mesh_.points.back() = placeIn(joint, share);
      if (std::all_of(tets.begin(), tets.end(), [&](Index t) { return staysPositive(t, joint, middle); }))
      {
        divideTets(tets, joint, middle);
        divideTriangles(joint, middle);
        return true;
      }
    }
    return false;
  }

private:
  Vector3 placeIn(const SheetJoint& joint, double share) const
  {
    const auto& p = mesh_.points;
    const auto& v = joint.vertex;
    const Vector3 between = share * p[v[0]] + (1 - share) * p[v[1]];
    return v[2] == None ? between : (2.0 / 3) * between + (1.0 / 3) * p[v[2]];
  }

  bool staysPositive(Index t, const SheetJoint& joint, Index middle) const
  {
    const auto& p = mesh_.points;
    const auto parts = divided(mesh_.tetrahedra[t], joint, middle);
    return std::all_of(parts.begin(), parts.end(),
      [&p](const auto& v) { return isPositive(p[v[0]], p[v[1]], p[v[2]], p[v[3]]); });
  }

  void divideTets(const std::vector<Index>& tets, const SheetJoint& joint, Index middle)
  {
    for (const Index t : tets)
    {
      const auto parts = divided(mesh_.tetrahedra[t], joint, middle);
      mesh_.tetrahedra[t] = parts[0];
      mesh_.tetrahedra.insert(mesh_.tetrahedra.end(), parts.begin() + 1, parts.end());
    }
  }

  void divideTriangles(const SheetJoint& joint, Index middle)
  {
    const std::size_t count = mesh_.triangles.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto triangle = mesh_.triangles[i];
      const bool hasAll = std::all_of(joint.vertex.begin(), joint.vertex.end(),
        [&triangle](Index v)
        { return v == None || std::find(triangle.begin(), triangle.end(), v) != triangle.end(); });
      if (hasAll)
      {
        const auto parts = divided(triangle, joint, middle);
        mesh_.triangles[i] = parts[0];
        mesh_.triangles.insert(mesh_.triangles.end(), parts.begin() + 1, parts.end());
        mesh_.trianglePatch.insert(mesh_.trianglePatch.end(), parts.size() - 1, mesh_.trianglePatch[i]);
      }
    }
  }

  MeshData& mesh_;
  const SheetSides& sides_;
};
} // namespace

std::vector<SheetJoint> findJoints(
  const MeshData& mesh, const std::vector<SheetTriangle>& sheets, const SheetSides& sides)
{
  return JointFinder(mesh, sheets, sides).run();
}

const SheetJoint* divideJoints(MeshData& mesh, const std::vector<SheetJoint>& joints, const SheetSides& sides)
{
  Division division(mesh, sides);
  const auto refused = std::find_if_not(
    joints.begin(), joints.end(), [&division](const SheetJoint& joint) { return division.divide(joint); });
  return refused == joints.end() ? nullptr : &*refused;
}
} // namespace ransmesh
