#include "QualityInput.h"

#include "MeshConversion.h"
#include "MixedConversion.h"
#include "RegionArrays.h"

#include "Mesh/MixedValidation.h"
#include "Support/DataContract.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkUnstructuredGrid.h"

namespace ransmesh
{
namespace
{
void readLayerIds(vtkUnstructuredGrid* grid, QualityInput& input)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(contract::LayerId);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return;
  }
  for (const Index cell : input.tetCell)
  {
    input.layerIds.push_back(static_cast<int>(array->GetTuple1(cell)));
  }
}

void readRegionsOf(vtkUnstructuredGrid* grid, QualityInput& input)
{
  input.regions = readRegions(grid, input.tetCell);
  for (const int number : input.regions)
  {
    const auto [name, isNew] = input.regionNames.try_emplace(number);
    if (isNew)
    {
      name->second = regionName(grid->GetFieldData(), number, input.patches[0].name);
    }
  }
}

Outcome readTets(vtkUnstructuredGrid* grid, QualityInput& input)
{
  const Outcome outcome = readMesh(grid, input.mesh, input.patches);
  for (vtkIdType c = 0; outcome.ok() && c < grid->GetNumberOfCells(); ++c)
  {
    (grid->GetCellType(c) == VTK_TETRA ? input.tetCell : input.triangleCell).push_back(static_cast<Index>(c));
  }
  return outcome;
}

// Of the layers' tetrahedra, how many are cut from wedges and hexahedra.
double shareInWedges(vtkUnstructuredGrid* grid, const QualityInput& input)
{
  std::size_t inLayers = 0;
  std::size_t inWedges = 0;
  for (std::size_t t = 0; t < input.layerIds.size(); ++t)
  {
    inLayers += input.layerIds[t] > 0;
    const int type = grid->GetCellType(input.tetCell[t]);
    inWedges += input.layerIds[t] > 0 && (type == VTK_WEDGE || type == VTK_HEXAHEDRON);
  }
  return inLayers > 0 ? static_cast<double>(inWedges) / static_cast<double>(inLayers) : 0;
}

Outcome readAndCut(vtkUnstructuredGrid* grid, QualityInput& input)
{
  MixedMesh mixed;
  std::vector<Index> cellIds;
  std::vector<Index> boundaryIds;
  if (Outcome outcome = readMixedMesh(grid, mixed, input.patches, cellIds, boundaryIds); !outcome.ok())
  {
    return outcome;
  }
  PrismSummary prisms;
  prisms.tetrahedra = mixed.tetrahedra.size();
  prisms.pyramids = mixed.pyramids.size();
  prisms.wedges = mixed.wedges.size();
  prisms.hexahedra = mixed.hexahedra.size();
  for (const Polygon& polygon : mixed.boundary)
  {
    prisms.quadrilaterals += isTriangle(polygon) ? 0 : 1;
  }
  const MixedFaults faults = findFaults(mixed);
  prisms.faults = faults.none() ? "" : faults.text();
  SplitMesh split = splitIntoTets(mixed);
  input.mesh = std::move(split.mesh);
  for (const Index cell : split.cell)
  {
    input.tetCell.push_back(cellIds[cell]);
  }
  for (const Index polygon : split.polygon)
  {
    input.triangleCell.push_back(boundaryIds[polygon]);
  }
  input.prisms = std::move(prisms);
  return Outcome::done();
}
} // namespace

Outcome readQualityInput(vtkUnstructuredGrid* grid, QualityInput& input)
{
  input = {};
  Outcome outcome = isMixed(grid) ? readAndCut(grid, input) : readTets(grid, input);
  if (outcome.ok())
  {
    readLayerIds(grid, input);
    readRegionsOf(grid, input);
    if (input.prisms)
    {
      input.prisms->shareOfLayers = shareInWedges(grid, input);
    }
  }
  return outcome;
}
} // namespace ransmesh
