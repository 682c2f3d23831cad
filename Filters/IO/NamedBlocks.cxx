#include "NamedBlocks.h"

#include "Support/DataContract.h"

#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

namespace ransmesh
{
namespace
{
const char* nameIn(vtkInformation* information)
{
  return information && information->Has(vtkCompositeDataSet::NAME())
    ? information->Get(vtkCompositeDataSet::NAME())
    : nullptr;
}

enum class Content
{
  Volume,
  Surface,
  Other
};

Content contentOf(vtkDataSet* data)
{
  bool volume = true;
  bool surface = true;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    const int type = data->GetCellType(c);
    volume =
      volume && (type == VTK_TETRA || type == VTK_PYRAMID || type == VTK_WEDGE || type == VTK_HEXAHEDRON);
    surface = surface && (type == VTK_TRIANGLE || type == VTK_QUAD);
  }
  return volume ? Content::Volume : surface ? Content::Surface : Content::Other;
}

PatchType typeOf(vtkDataSet* data)
{
  auto* array =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(contract::BlockPatchType));
  return array && array->GetNumberOfValues() > 0 ? patchTypeOf(array->GetValue(0)).value_or(PatchType::Patch)
                                                 : PatchType::Patch;
}

Outcome add(vtkDataObject* object, const char* name, NamedBlocks& blocks)
{
  auto* data = vtkDataSet::SafeDownCast(object);
  if (!data || data->GetNumberOfCells() == 0)
  {
    return Outcome::done();
  }
  NamedBlock block{ data, { name ? name : "", typeOf(data) } };
  switch (contentOf(data))
  {
    case Content::Volume:
      blocks.volumes.push_back(block);
      return Outcome::done();
    case Content::Surface:
      blocks.surfaces.push_back(block);
      return Outcome::done();
    default:
      return Outcome::badInput("block '" + block.patch.name +
        "' holds other cells than tetrahedra, pyramids, wedges and hexahedra, or triangles and "
        "quadrilaterals "
        "alone; leave it out or convert it");
  }
}

Outcome addAll(vtkPartitionedDataSetCollection* input, NamedBlocks& blocks)
{
  for (unsigned int i = 0; i < input->GetNumberOfPartitionedDataSets(); ++i)
  {
    const char* name = input->HasMetaData(i) ? nameIn(input->GetMetaData(i)) : nullptr;
    for (unsigned int part = 0; part < input->GetNumberOfPartitions(i); ++part)
    {
      if (Outcome outcome = add(input->GetPartitionAsDataObject(i, part), name, blocks); !outcome.ok())
      {
        return outcome;
      }
    }
  }
  return Outcome::done();
}

Outcome addAll(vtkCompositeDataSet* input, NamedBlocks& blocks)
{
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(input->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    const char* name = iterator->HasCurrentMetaData() ? nameIn(iterator->GetCurrentMetaData()) : nullptr;
    if (Outcome outcome = add(iterator->GetCurrentDataObject(), name, blocks); !outcome.ok())
    {
      return outcome;
    }
  }
  return Outcome::done();
}
} // namespace

Outcome findBlocks(vtkCompositeDataSet* input, NamedBlocks& blocks)
{
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(input);
  if (Outcome outcome = collection ? addAll(collection, blocks) : addAll(input, blocks); !outcome.ok())
  {
    return outcome;
  }
  if (blocks.volumes.empty())
  {
    return Outcome::badInput("no block holds volume cells: load the volume, too");
  }
  if (blocks.surfaces.empty())
  {
    return Outcome::badInput("no block holds boundary faces: let the reader load the boundary patches, too");
  }
  return Outcome::done();
}
} // namespace ransmesh
