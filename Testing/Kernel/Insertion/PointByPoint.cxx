#include "Insertion/PointByPoint.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace enrichment_checks
{
using namespace ransmesh;

namespace
{
using Face = std::array<Index, 3>;

struct LinePoints
{
  Index root = None;         // of the input
  std::vector<Index> points; // from the wall to the top
};

// The columns' points by column; those of a fan have tops with numbers below those of their other points.
std::map<Index, LinePoints> findLines(const EnrichedMesh& enriched)
{
  std::map<Index, LinePoints> lines;
  for (std::size_t i = 0; i < enriched.mesh.points.size(); ++i)
  {
    if (enriched.column[i] != None)
    {
      LinePoints& line = lines[enriched.column[i]];
      line.root = enriched.origin[i];
      line.points.push_back(static_cast<Index>(i));
    }
  }
  const auto mains = static_cast<Index>(enriched.wallPoints.size());
  std::map<Index, Index> baseOf; // by root
  for (auto& [column, line] : lines)
  {
    if (column < mains)
    {
      baseOf[line.root] = line.points[0];
    }
    else
    {
      std::rotate(line.points.begin(), line.points.begin() + 1, line.points.end());
      line.points.insert(line.points.begin(), baseOf.at(line.root));
    }
  }
  return lines;
}

// The faces of only one of the tetrahedra in the layers, or of those beyond.
std::set<Face> openFaces(const EnrichedMesh& enriched, bool ofLayers)
{
  std::set<Face> open;
  for (std::size_t t = 0; t < enriched.layer.size(); ++t)
  {
    for (int skip = 0; (enriched.layer[t] > 0) == ofLayers && skip < 4; ++skip)
    {
      const auto& v = enriched.mesh.tetrahedra[t];
      Face face{ v[(skip + 1) % 4], v[(skip + 2) % 4], v[(skip + 3) % 4] };
      std::sort(face.begin(), face.end());
      if (!open.insert(face).second)
      {
        open.erase(face);
      }
    }
  }
  return open;
}

// The triangles between what lies beyond the layers and these.
std::vector<Face> findFront(const EnrichedMesh& enriched)
{
  const std::set<Face> below = openFaces(enriched, true);
  const std::set<Face> above = openFaces(enriched, false);
  std::vector<Face> front;
  std::set_intersection(below.begin(), below.end(), above.begin(), above.end(), std::back_inserter(front));
  return front;
}

class Inserter
{
public:
  explicit Inserter(std::vector<Face> front)
    : faces_(std::move(front))
  {
    for (std::size_t f = 0; f < faces_.size(); ++f)
    {
      for (const Index v : faces_[f])
      {
        facesAt_[v].push_back(f);
      }
    }
  }

  void insertBelow(Index top, Index point, int layer)
  {
    for (const std::size_t f : facesAt_[top])
    {
      Corners tet{ faces_[f][0], faces_[f][1], faces_[f][2], point };
      std::sort(tet.begin(), tet.end());
      // In a fan the columns end in one point of the wall: a face between two of them becomes an edge.
      if (std::adjacent_find(tet.begin(), tet.end()) == tet.end())
      {
        made.emplace(tet, layer);
      }
      std::replace(faces_[f].begin(), faces_[f].end(), top, point);
      facesAt_[point].push_back(f);
    }
    facesAt_.erase(top);
  }

  // Without those that became edges or points.
  std::set<Face> faces() const
  {
    std::set<Face> result;
    for (Face face : faces_)
    {
      std::sort(face.begin(), face.end());
      if (std::adjacent_find(face.begin(), face.end()) == face.end())
      {
        result.insert(face);
      }
    }
    return result;
  }

  LayerTets made;

private:
  std::vector<Face> faces_;
  std::map<Index, std::vector<std::size_t>> facesAt_;
};
} // namespace

LayerTets writtenLayers(const EnrichedMesh& enriched)
{
  LayerTets result;
  for (std::size_t t = 0; t < enriched.layer.size(); ++t)
  {
    if (enriched.layer[t] > 0)
    {
      Corners tet = enriched.mesh.tetrahedra[t];
      std::sort(tet.begin(), tet.end());
      result.emplace(tet, enriched.layer[t]);
    }
  }
  return result;
}

LayerTets insertPointByPoint(const EnrichedMesh& enriched, std::vector<std::array<Index, 3>>& left)
{
  const std::map<Index, LinePoints> lines = findLines(enriched);
  // Within a level in order of roots, then of columns, the last first.
  std::vector<std::pair<Index, Index>> order;
  int highest = 0;
  for (const auto& [column, line] : lines)
  {
    order.emplace_back(line.root, column);
    highest = std::max(highest, static_cast<int>(line.points.size()) - 1);
  }
  std::sort(order.rbegin(), order.rend());
  Inserter inserter(findFront(enriched));
  for (int level = highest; level > 0; --level)
  {
    for (const auto& [root, column] : order)
    {
      const std::vector<Index>& points = lines.at(column).points;
      if (level < static_cast<int>(points.size()))
      {
        inserter.insertBelow(points[level], points[level - 1], level);
      }
    }
  }
  const std::set<Face> faces = inserter.faces();
  left.assign(faces.begin(), faces.end());
  return inserter.made;
}
} // namespace enrichment_checks
