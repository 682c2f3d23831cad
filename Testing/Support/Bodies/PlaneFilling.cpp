#include "Bodies/PlaneFilling.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <deque>

namespace bodies
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Data =
  CGAL::Triangulation_data_structure_2<Vertex, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data>;
using Nearest = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
using Point = Kernel::Point_2;

double distanceOf(const PlanePoint& a, const PlanePoint& b)
{
  return std::hypot(a.x - b.x, a.y - b.y);
}

class Filling
{
public:
  Filling(const std::vector<Loop>& loops, double growth)
    : loops_(loops)
    , growth_(growth)
  {
  }

  PlaneTriangles run()
  {
    addLoops();
    grow();
    constexpr int rounds = 6;
    for (int i = 0; i < rounds; ++i)
    {
      triangulate();
      smooth();
    }
    triangulate();
    return std::move(result_);
  }

private:
  struct Seed
  {
    int point;
    double angle; // of the first direction in which neighbours are tried
  };

  void addLoops()
  {
    for (const Loop& loop : loops_)
    {
      const std::size_t n = loop.size();
      for (std::size_t i = 0; i < n; ++i)
      {
        const PlanePoint& next = loop[(i + 1) % n];
        const double size = (distanceOf(loop[i], next) + distanceOf(loop[i], loop[(i + n - 1) % n])) / 2;
        seeds_.push_back(
          { static_cast<int>(size_.size()), std::atan2(next.y - loop[i].y, next.x - loop[i].x) });
        add(loop[i], size);
      }
    }
    fixed_ = size_.size();
  }

  void add(const PlanePoint& p, double size)
  {
    nearest_.insert(Point(p.x, p.y))->info() = static_cast<int>(size_.size());
    result_.points.push_back(p);
    size_.push_back(size);
  }

  // From the loops inward: around each point six neighbours, where there is room.
  void grow()
  {
    while (!seeds_.empty())
    {
      const Seed seed = seeds_.front();
      seeds_.pop_front();
      for (int k = 0; k < 6; ++k)
      {
        const double angle = seed.angle + k * M_PI / 3;
        const double step = size_[seed.point] * (1 + growth_ / 2);
        const PlanePoint& from = result_.points[seed.point];
        tryPoint({ from.x + step * std::cos(angle), from.y + step * std::sin(angle) }, angle);
      }
    }
  }

  void tryPoint(const PlanePoint& p, double angle)
  {
    const int near = nearest_.nearest_vertex(Point(p.x, p.y))->info();
    const double space = distanceOf(p, result_.points[near]);
    const double size = size_[near] + growth_ * space;
    constexpr double room = 0.75;
    if (space >= room * size && isInside(p))
    {
      seeds_.push_back({ static_cast<int>(size_.size()), angle });
      add(p, size);
    }
  }

  bool isInside(const PlanePoint& p) const
  {
    bool inside = false;
    for (const Loop& loop : loops_)
    {
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const PlanePoint& a = loop[i];
        const PlanePoint& b = loop[(i + 1) % loop.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
        {
          inside = !inside;
        }
      }
    }
    return inside;
  }

  void triangulate()
  {
    Constrained plane;
    std::vector<Constrained::Vertex_handle> handles;
    for (const PlanePoint& p : result_.points)
    {
      handles.push_back(plane.insert(Point(p.x, p.y)));
      handles.back()->info() = static_cast<int>(handles.size()) - 1;
    }
    std::size_t first = 0;
    for (const Loop& loop : loops_)
    {
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        plane.insert_constraint(handles[first + i], handles[first + (i + 1) % loop.size()]);
      }
      first += loop.size();
    }
    result_.triangles.clear();
    for (const auto face : plane.finite_face_handles())
    {
      const std::array<int, 3> t = { face->vertex(0)->info(), face->vertex(1)->info(),
        face->vertex(2)->info() };
      if (isInside(centre(t)))
      {
        result_.triangles.push_back(t);
      }
    }
  }

  PlanePoint centre(const std::array<int, 3>& t) const
  {
    PlanePoint sum;
    for (const int v : t)
    {
      sum.x += result_.points[v].x / 3;
      sum.y += result_.points[v].y / 3;
    }
    return sum;
  }

  // Points that are not on a loop move to the mean of the triangles around them, by area.
  void smooth()
  {
    std::vector<PlanePoint> sum(result_.points.size());
    std::vector<double> weight(result_.points.size(), 0);
    for (const auto& t : result_.triangles)
    {
      const PlanePoint c = centre(t);
      const PlanePoint& a = result_.points[t[0]];
      const PlanePoint& b = result_.points[t[1]];
      const PlanePoint& d = result_.points[t[2]];
      const double area = (b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x);
      for (const int v : t)
      {
        sum[v].x += area * c.x;
        sum[v].y += area * c.y;
        weight[v] += area;
      }
    }
    for (std::size_t i = fixed_; i < sum.size(); ++i)
    {
      if (weight[i] > 0)
      {
        result_.points[i] = { sum[i].x / weight[i], sum[i].y / weight[i] };
      }
    }
  }

  const std::vector<Loop>& loops_;
  double growth_;
  std::size_t fixed_ = 0;
  std::vector<double> size_;
  std::deque<Seed> seeds_;
  Nearest nearest_;
  PlaneTriangles result_;
};
} // namespace

PlaneTriangles fillPlane(const std::vector<Loop>& loops, double growth)
{
  return Filling(loops, growth).run();
}

void appendLine(Loop& loop, const PlanePoint& a, const PlanePoint& b, int n)
{
  for (int i = 0; i < n; ++i)
  {
    const double s = static_cast<double>(i) / n;
    loop.push_back({ a.x + s * (b.x - a.x), a.y + s * (b.y - a.y) });
  }
}
} // namespace bodies
