#include "SurfacePieces.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiPieceDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"
#include "vtkTriangleFilter.h"

namespace ransmesh
{
namespace
{
std::string nameIn(vtkInformation* metaData)
{
  const char* name = metaData && metaData->Has(vtkCompositeDataSet::NAME())
    ? metaData->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  return name ? name : "";
}

std::string nameIn(vtkFieldData* fieldData)
{
  for (const char* key : { "NAME", "Name", "name" })
  {
    auto* array = vtkStringArray::SafeDownCast(fieldData->GetAbstractArray(key));
    if (array && array->GetNumberOfValues() == 1)
    {
      return array->GetValue(0);
    }
  }
  return "";
}

vtkSmartPointer<vtkPolyData> triangulated(vtkPolyData* surface)
{
  const bool onlyTriangles = surface->GetNumberOfCells() == surface->GetNumberOfPolys() &&
    surface->GetPolys()->GetMaxCellSize() == 3 &&
    surface->GetPolys()->GetNumberOfConnectivityIds() == 3 * surface->GetNumberOfPolys();
  if (onlyTriangles)
  {
    return surface;
  }
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(surface);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  return filter->GetOutput();
}

class Collector
{
public:
  explicit Collector(std::vector<SurfacePiece>& pieces)
    : pieces_(pieces)
  {
  }

  Outcome collect(vtkDataObject* data, const std::string& name)
  {
    if (auto* surface = vtkPolyData::SafeDownCast(data))
    {
      add(surface, name);
      return Outcome::done();
    }
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      return collectNamed(blocks, blocks->GetNumberOfBlocks(), name,
        [blocks](unsigned i) { return blocks->HasMetaData(i) ? blocks->GetMetaData(i) : nullptr; });
    }
    if (auto* sets = vtkPartitionedDataSetCollection::SafeDownCast(data))
    {
      return collectNamed(sets, sets->GetNumberOfPartitionedDataSets(), name,
        [sets](unsigned i) { return sets->HasMetaData(i) ? sets->GetMetaData(i) : nullptr; });
    }
    return collectParts(data, name);
  }

private:
  template <class Tree, class MetaData>
  Outcome collectNamed(Tree* tree, unsigned count, const std::string& name, MetaData metaData)
  {
    for (unsigned i = 0; i < count; ++i)
    {
      vtkDataObject* child = childOf(tree, i);
      const std::string own = nameIn(metaData(i));
      Outcome outcome = child ? collect(child, own.empty() ? name : own) : Outcome::done();
      if (!outcome.ok())
      {
        return outcome;
      }
    }
    return Outcome::done();
  }

  static vtkDataObject* childOf(vtkMultiBlockDataSet* tree, unsigned i) { return tree->GetBlock(i); }
  static vtkDataObject* childOf(vtkPartitionedDataSetCollection* tree, unsigned i)
  {
    return tree->GetPartitionedDataSet(i);
  }

  // The parts of one block share its name.
  Outcome collectParts(vtkDataObject* data, const std::string& name)
  {
    auto* parts = vtkPartitionedDataSet::SafeDownCast(data);
    if (!parts)
    {
      return Outcome::badInput("the input" + (name.empty() ? "" : " '" + name + "'") + " is a " +
        data->GetClassName() + ", not a surface: extract the surface first");
    }
    for (unsigned i = 0; i < parts->GetNumberOfPartitions(); ++i)
    {
      vtkDataObject* part = parts->GetPartitionAsDataObject(i);
      Outcome outcome = part ? collect(part, name) : Outcome::done();
      if (!outcome.ok())
      {
        return outcome;
      }
    }
    return Outcome::done();
  }

  void add(vtkPolyData* surface, const std::string& name)
  {
    if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0)
    {
      pieces_.push_back({ triangulated(surface), name.empty() ? nameIn(surface->GetFieldData()) : name });
    }
  }

  std::vector<SurfacePiece>& pieces_;
};
} // namespace

Outcome collectPieces(const std::vector<vtkDataObject*>& inputs, std::vector<SurfacePiece>& pieces)
{
  Collector collector(pieces);
  for (vtkDataObject* input : inputs)
  {
    Outcome outcome = input ? collector.collect(input, "") : Outcome::done();
    if (!outcome.ok())
    {
      return outcome;
    }
  }
  return Outcome::done();
}
} // namespace ransmesh
