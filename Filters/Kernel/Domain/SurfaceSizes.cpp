#include "Domain/SurfaceSizes.h"

#include "Triangles/SurfaceEdges.h"

#include <queue>

namespace ransmesh
{
namespace
{
int longestSide(const SurfaceMesh& surface, const std::array<Index, 3>& t)
{
  int longest = 0;
  double best = -1;
  for (int i = 0; i < 3; ++i)
  {
    // The two triangles at an edge must agree on its length to the last bit.
    const Index a = std::min(t[i], t[(i + 1) % 3]);
    const Index b = std::max(t[i], t[(i + 1) % 3]);
    const double length = distance(surface.points[a], surface.points[b]);
    if (length > best)
    {
      best = length;
      longest = i;
    }
  }
  return longest;
}

class Halving
{
public:
  explicit Halving(SurfaceMesh& surface)
    : surface_(surface)
    , edges_(sortedEdges(surface))
    , edgeOf_(surface.triangles.size())
  {
    forEachEdge(edges_,
      [this](const SurfaceEdge* first, const SurfaceEdge* last)
      {
        const auto number = static_cast<Index>(groups_.size());
        groups_.push_back({ first, last });
        for (const SurfaceEdge* e = first; e != last; ++e)
        {
          edgeOf_[e->triangle][sideOf(surface_.triangles[e->triangle], *e)] = number;
        }
      });
    middle_.assign(groups_.size(), None);
  }

  // Marks edges that are too long, and then the longest edge of every triangle with a marked edge.
  std::size_t mark(const std::function<double(const Vector3&)>& limit, double factor)
  {
    std::vector<Index> queue;
    for (std::size_t g = 0; g < groups_.size(); ++g)
    {
      const Vector3& a = surface_.points[groups_[g].first->a];
      const Vector3& b = surface_.points[groups_[g].first->b];
      if (distance(a, b) > factor * limit(0.5 * (a + b)))
      {
        halve(static_cast<Index>(g), queue);
      }
    }
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      for (const SurfaceEdge* e = groups_[queue[i]].first; e != groups_[queue[i]].last; ++e)
      {
        halve(edgeOf_[e->triangle][longestSide(surface_, surface_.triangles[e->triangle])], queue);
      }
    }
    return queue.size();
  }

  void splitTriangles()
  {
    const std::size_t count = surface_.triangles.size();
    for (std::size_t t = 0; t < count; ++t)
    {
      split(t);
    }
  }

private:
  struct Group
  {
    const SurfaceEdge* first;
    const SurfaceEdge* last;
  };

  static int sideOf(const std::array<Index, 3>& t, const SurfaceEdge& e)
  {
    for (int i = 0; i < 2; ++i)
    {
      const Index a = std::min(t[i], t[i + 1]);
      const Index b = std::max(t[i], t[i + 1]);
      if (a == e.a && b == e.b)
      {
        return i;
      }
    }
    return 2;
  }

  void halve(Index group, std::vector<Index>& queue)
  {
    if (middle_[group] == None)
    {
      const SurfaceEdge& e = *groups_[group].first;
      middle_[group] = static_cast<Index>(surface_.points.size());
      surface_.points.push_back(0.5 * (surface_.points[e.a] + surface_.points[e.b]));
      queue.push_back(group);
    }
  }

  // A halved triangle always has its longest side halved: that side is cut first, the halves then.
  void split(std::size_t t)
  {
    const std::array<Index, 3> v = surface_.triangles[t];
    std::array<Index, 3> m;
    for (int i = 0; i < 3; ++i)
    {
      m[i] = middle_[edgeOf_[t][i]];
    }
    const int i = longestSide(surface_, v);
    if (m[i] == None)
    {
      return;
    }
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    surface_.triangles[t] = { v[i], m[i], v[k] };
    if (m[k] != None)
    {
      surface_.triangles[t] = { v[i], m[i], m[k] };
      add({ m[i], v[k], m[k] }, t);
    }
    if (m[j] != None)
    {
      add({ m[i], v[j], m[j] }, t);
      add({ m[i], m[j], v[k] }, t);
    }
    else
    {
      add({ m[i], v[j], v[k] }, t);
    }
  }

  void add(const std::array<Index, 3>& triangle, std::size_t parent)
  {
    const int patch = surface_.patch[parent];
    surface_.triangles.push_back(triangle);
    surface_.patch.push_back(patch);
  }

  SurfaceMesh& surface_;
  std::vector<SurfaceEdge> edges_;
  std::vector<std::array<Index, 3>> edgeOf_;
  std::vector<Group> groups_;
  std::vector<Index> middle_;
};
} // namespace

std::vector<double> sizesOnSurface(const SurfaceMesh& surface, double slope)
{
  std::vector<double> size(surface.points.size(), 0);
  std::vector<int> count(surface.points.size(), 0);
  std::vector<std::vector<Index>> neighbours(surface.points.size());
  forEachEdge(sortedEdges(surface),
    [&](const SurfaceEdge* e, const SurfaceEdge*)
    {
      const double length = distance(surface.points[e->a], surface.points[e->b]);
      for (const Index v : { e->a, e->b })
      {
        size[v] += length;
        ++count[v];
      }
      neighbours[e->a].push_back(e->b);
      neighbours[e->b].push_back(e->a);
    });
  // Dijkstra's way, from the smallest size outward.
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t v = 0; v < size.size(); ++v)
  {
    size[v] /= std::max(1, count[v]);
    queue.push({ size[v], static_cast<Index>(v) });
  }
  while (!queue.empty())
  {
    const auto [here, v] = queue.top();
    queue.pop();
    if (here != size[v])
    {
      continue; // a smaller size has come since
    }
    for (const Index w : neighbours[v])
    {
      const double allowed = here + slope * distance(surface.points[v], surface.points[w]);
      if (allowed < size[w])
      {
        size[w] = allowed;
        queue.push({ allowed, w });
      }
    }
  }
  return size;
}

bool halveLongEdges(SurfaceMesh& surface, const std::function<double(const Vector3&)>& limit,
  std::size_t mostTriangles, double factor)
{
  while (surface.triangles.size() <= mostTriangles)
  {
    Halving halving(surface);
    if (halving.mark(limit, factor) == 0)
    {
      return true;
    }
    halving.splitTriangles();
  }
  return false;
}

double enclosedVolume(const SurfaceMesh& surface)
{
  return surface.points.empty() ? 0 : enclosedVolume(surface, surface.points[0]);
}

double enclosedVolume(const SurfaceMesh& surface, const Vector3& apex)
{
  double six = 0;
  for (const auto& t : surface.triangles)
  {
    const auto& p = surface.points;
    six += dot(p[t[0]] - apex, cross(p[t[1]] - apex, p[t[2]] - apex));
  }
  return std::fabs(six) / 6;
}
} // namespace ransmesh
