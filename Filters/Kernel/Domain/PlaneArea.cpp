#include "Domain/PlaneArea.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <map>
#include <utility>

namespace ransmesh
{
namespace
{
struct FaceState
{
  bool isKnown = false;
  bool belongs = false;
  int part = -1; // faces of one part are not divided by edges
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using Faces = CGAL::Triangulation_face_base_with_info_2<FaceState, Kernel,
  CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel,
  CGAL::Triangulation_data_structure_2<Vertices, Faces>, CGAL::No_constraint_intersection_tag>;
using Face = Triangulation::Face_handle;

enum class EdgeKind
{
  None,
  Outline,
  Border,
  Inside
};

class Plane
{
public:
  Plane(const std::vector<Vector3>& points, int axis)
    : points_(points)
    , axis_(axis)
  {
  }

  // False where edges cross.
  bool insert(const PlaneEdges& edges)
  {
    try
    {
      insert(edges.inside, EdgeKind::Inside);
      insert(edges.borders, EdgeKind::Border);
      insert(edges.outline, EdgeKind::Outline);
    }
    catch (const Triangulation::Intersection_of_constraints_exception&)
    {
      return false;
    }
    return cdt_.dimension() == 2;
  }

  // False where the edges do not close.
  bool classify(std::optional<Index> seed)
  {
    const Face first = seed ? faceInsideAt(*seed) : cdt_.infinite_face();
    first->info() = { true, seed.has_value(), 0 };
    std::vector<Face> open = { first };
    std::vector<Face> across; // first faces of further parts
    for (int part = 0; !open.empty(); ++part)
    {
      if (!fill(open, part, across))
      {
        return false;
      }
      while (!across.empty() && across.back()->info().part >= 0)
      {
        across.pop_back();
      }
      if (!across.empty())
      {
        open = { across.back() };
        across.back()->info().part = part + 1;
      }
    }
    return true;
  }

  PlaneArea area() const
  {
    PlaneArea area;
    for (const auto& [edge, kind] : kinds_)
    {
      const auto [face, side] = faceOf(edge);
      if (face->info().belongs || face->neighbor(side)->info().belongs)
      {
        area.edges.push_back({ edge.first, edge.second });
      }
    }
    area.holes = holes();
    return area;
  }

private:
  using Edge = std::pair<Index, Index>;

  Kernel::Point_2 flat(Index v) const
  {
    const Vector3& p = points_[v];
    return { p[(axis_ + 1) % 3], p[(axis_ + 2) % 3] };
  }

  Triangulation::Vertex_handle vertex(Index v)
  {
    const auto [found, isNew] = vertices_.try_emplace(v);
    if (isNew)
    {
      found->second = cdt_.insert(flat(v));
      found->second->info() = v;
    }
    return found->second;
  }

  void insert(const std::vector<std::array<Index, 2>>& edges, EdgeKind kind)
  {
    for (const auto& [a, b] : edges)
    {
      cdt_.insert_constraint(vertex(a), vertex(b));
      kinds_[std::minmax(a, b)] = kind;
    }
  }

  EdgeKind kindOf(Face face, int side) const
  {
    if (!face->is_constrained(side))
    {
      return EdgeKind::None;
    }
    const auto found =
      kinds_.find(std::minmax(face->vertex(cdt_.cw(side))->info(), face->vertex(cdt_.ccw(side))->info()));
    return found == kinds_.end() ? EdgeKind::Border : found->second;
  }

  // A face at the vertex that lies within the outline.
  Face faceInsideAt(Index v)
  {
    auto face = cdt_.incident_faces(vertex(v));
    while (cdt_.is_infinite(Face(face)))
    {
      ++face;
    }
    return face;
  }

  // All that no edge divides from the faces in `open`. False where what belongs meets what does not.
  bool fill(std::vector<Face>& open, int part, std::vector<Face>& across)
  {
    while (!open.empty())
    {
      const Face face = open.back();
      open.pop_back();
      face->info().part = part;
      for (int side = 0; side < 3; ++side)
      {
        const Face next = face->neighbor(side);
        const EdgeKind kind = kindOf(face, side);
        if (kind == EdgeKind::Outline)
        {
          continue;
        }
        const bool belongs = face->info().belongs != (kind == EdgeKind::Border);
        if (next->info().isKnown && next->info().belongs != belongs)
        {
          return false;
        }
        if (!next->info().isKnown)
        {
          next->info() = { true, belongs, kind == EdgeKind::None ? part : -1 };
          (kind == EdgeKind::None ? open : across).push_back(next);
        }
        else if (kind == EdgeKind::None && next->info().part < 0)
        {
          next->info().part = part;
          open.push_back(next);
        }
      }
    }
    return true;
  }

  std::pair<Face, int> faceOf(const Edge& edge) const
  {
    Face face;
    int side = 0;
    cdt_.is_edge(vertices_.at(edge.first), vertices_.at(edge.second), face, side);
    return { face, side };
  }

  // The centre of the largest face of each bounded part that does not belong to the area.
  std::vector<Vector3> holes() const
  {
    const int outside = cdt_.infinite_face()->info().part;
    std::map<int, std::pair<double, Vector3>> largest;
    for (const auto face : cdt_.finite_face_handles())
    {
      const FaceState& state = face->info();
      if (!state.isKnown || state.belongs || state.part == outside)
      {
        continue;
      }
      const double area = cdt_.triangle(face).area();
      auto& best = largest[state.part];
      if (area > best.first)
      {
        best = { area, centreOfFace(face) };
      }
    }
    std::vector<Vector3> places;
    places.reserve(largest.size());
    for (const auto& [part, best] : largest)
    {
      places.push_back(best.second);
    }
    return places;
  }

  Vector3 centreOfFace(Face face) const
  {
    Vector3 centre;
    for (int i = 0; i < 3; ++i)
    {
      centre += (1.0 / 3) * points_[face->vertex(i)->info()];
    }
    centre[axis_] = points_[face->vertex(0)->info()][axis_];
    return centre;
  }

  const std::vector<Vector3>& points_;
  int axis_;
  Triangulation cdt_;
  std::map<Index, Triangulation::Vertex_handle> vertices_;
  std::map<Edge, EdgeKind> kinds_;
};
} // namespace

Outcome findPlaneArea(const std::vector<Vector3>& points, int axis, const PlaneEdges& edges,
  std::optional<Index> seed, PlaneArea& area)
{
  Plane plane(points, axis);
  const std::string where = std::string("in the plane across ") + "xyz"[axis];
  if (!plane.insert(edges))
  {
    return Outcome::badInput(
      "edges of the surface cross, or enclose nothing, " + where + ": parts overlap there; separate them");
  }
  if (!plane.classify(seed))
  {
    return Outcome::badInput("the surface's edges do not close around an area " + where +
      ": close the surface, or move the plane a little");
  }
  area = plane.area();
  return Outcome::done();
}
} // namespace ransmesh
