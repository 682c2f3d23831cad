#include "Quality/CellMeasures.h"

#include "Geometry/TetrahedronMeasures.h"

namespace ransmesh
{
CellMeasures measureCells(const MeshData& mesh)
{
  CellMeasures cells;
  for (auto* values : { &cells.volume, &cells.longestEdge, &cells.shortestEdge, &cells.largestDihedral,
         &cells.smallestDihedral, &cells.stretching, &cells.quality })
  {
    values->reserve(mesh.tetrahedra.size());
  }
  const auto& p = mesh.points;
  for (const auto& v : mesh.tetrahedra)
  {
    const TetrahedronMeasures m = measure(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
    cells.volume.push_back(m.volume);
    cells.longestEdge.push_back(m.longestEdge);
    cells.shortestEdge.push_back(m.shortestEdge);
    cells.largestDihedral.push_back(m.largestDihedral);
    cells.smallestDihedral.push_back(m.smallestDihedral);
    cells.stretching.push_back(m.stretching());
    cells.quality.push_back(m.quality);
  }
  return cells;
}
} // namespace ransmesh
