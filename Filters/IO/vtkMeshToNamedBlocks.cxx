#include "vtkMeshToNamedBlocks.h"

#include "MeshView.h"
#include "PatchLabels.h"

#include "Support/DataContract.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkMeshToNamedBlocks);

namespace
{
using namespace ransmesh;

// A region's cells; all regions share the mesh's points.
vtkSmartPointer<vtkUnstructuredGrid> volumeOf(
  vtkUnstructuredGrid* grid, const MeshView& mesh, std::size_t region)
{
  auto volume = vtkSmartPointer<vtkUnstructuredGrid>::New();
  volume->SetPoints(grid->GetPoints());
  volume->GetPointData()->ShallowCopy(grid->GetPointData());
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  vtkCellData* data = volume->GetCellData();
  data->CopyAllOn();
  data->CopyAllocate(grid->GetCellData(), mesh.regions()[region].count());
  for (vtkIdType i = 0; i < mesh.numberOfCells(); ++i)
  {
    if (mesh.regionOf(i) == region)
    {
      const Corners cell = mesh.unturnedCell(i);
      const vtkIdType number = cells->InsertNextCell(cell.count, cell.begin());
      types->InsertNextValue(static_cast<unsigned char>(grid->GetCellType(mesh.gridCell(i))));
      data->CopyData(grid->GetCellData(), mesh.gridCell(i), number);
    }
  }
  volume->SetCells(types, cells);
  return volume;
}

// The mesh's points that patches have, numbered anew for each patch.
class PatchPoints
{
public:
  explicit PatchPoints(const MeshView& mesh)
    : numbers_(mesh.numberOfPoints(), -1)
  {
  }

  // A patch's points begin.
  void begin()
  {
    for (const vtkIdType p : points_)
    {
      numbers_[p] = -1;
    }
    points_.clear();
  }
  vtkIdType numberOf(vtkIdType point)
  {
    if (numbers_[point] < 0)
    {
      numbers_[point] = static_cast<vtkIdType>(points_.size());
      points_.push_back(point);
    }
    return numbers_[point];
  }
  const std::vector<vtkIdType>& points() const { return points_; }

private:
  std::vector<vtkIdType> numbers_;
  std::vector<vtkIdType> points_;
};

void copyPoints(vtkUnstructuredGrid* grid, const PatchPoints& numbering, vtkPolyData* surface)
{
  const auto count = static_cast<vtkIdType>(numbering.points().size());
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(contract::MeshPointId);
  ids->SetNumberOfValues(count);
  vtkPointData* data = surface->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(grid->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType of = numbering.points()[i];
    points->SetPoint(i, grid->GetPoint(of));
    ids->SetValue(i, of);
    data->CopyData(grid->GetPointData(), of, i);
  }
  surface->SetPoints(points);
  data->AddArray(ids);
}

vtkSmartPointer<vtkPolyData> surfaceOf(
  vtkUnstructuredGrid* grid, const MeshView& mesh, const BoundaryPatch& patch, PatchPoints& numbering)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> faces;
  vtkCellData* data = surface->GetCellData();
  data->CopyAllOn();
  data->CopyAllocate(grid->GetCellData(), patch.count());
  numbering.begin();
  for (vtkIdType f = 0; f < patch.count(); ++f)
  {
    Corners face = mesh.face(patch.first + f);
    std::transform(face.begin(), face.end(), face.points.begin(),
      [&numbering](vtkIdType p) { return numbering.numberOf(p); });
    faces->InsertNextCell(face.count, face.begin());
    data->CopyData(grid->GetCellData(), mesh.gridFace(patch.first + f), f);
  }
  surface->SetPolys(faces);
  copyPoints(grid, numbering, surface);
  vtkNew<vtkStringArray> type;
  type->SetName(contract::BlockPatchType);
  type->InsertNextValue(std::string(nameOf(patch.type)));
  surface->GetFieldData()->AddArray(type);
  return surface;
}

class Blocks
{
public:
  explicit Blocks(vtkPartitionedDataSetCollection* output)
    : output_(output)
  {
    assembly_->SetRootNodeName("Mesh");
    volume_ = assembly_->AddNode("volume");
    boundary_ = assembly_->AddNode("boundary");
    output_->SetDataAssembly(assembly_);
  }

  // label: the name, with characters that an assembly allows, and unlike all others.
  void addVolume(vtkDataSet* block, const std::string& name, const std::string& label)
  {
    add(block, name, assembly_->AddNode(vtkDataAssembly::MakeValidNodeName(label.c_str()).c_str(), volume_));
  }
  void addPatch(vtkDataSet* block, const BoundaryPatch& patch, const std::string& label)
  {
    const int node = assembly_->AddNode(vtkDataAssembly::MakeValidNodeName(label.c_str()).c_str(), boundary_);
    assembly_->SetAttribute(node, "type", std::string(nameOf(patch.type)).c_str());
    add(block, patch.name, node);
  }

private:
  void add(vtkDataSet* block, const std::string& name, int node)
  {
    const unsigned int number = output_->GetNumberOfPartitionedDataSets();
    output_->SetNumberOfPartitionedDataSets(number + 1);
    output_->SetPartition(number, 0, block);
    output_->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), name.c_str());
    assembly_->SetAttribute(node, "label", name.c_str());
    assembly_->AddDataSetIndex(node, number);
  }

  vtkPartitionedDataSetCollection* output_;
  vtkNew<vtkDataAssembly> assembly_;
  int volume_;
  int boundary_;
};
} // namespace

int vtkMeshToNamedBlocks::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkMeshToNamedBlocks::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* grid = vtkUnstructuredGrid::GetData(inputVector[0]);
  auto* output = vtkPartitionedDataSetCollection::GetData(outputVector);
  MeshView mesh;
  if (const Outcome outcome = MeshView::make(grid, mesh); !outcome.ok())
  {
    vtkErrorMacro("" << outcome.message);
    return 0;
  }
  Blocks blocks(output);
  const std::vector<std::string> regions = regionLabels(mesh.regions(), "_-.");
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    blocks.addVolume(volumeOf(grid, mesh, r), mesh.regions()[r].name, regions[r]);
  }
  const std::vector<std::string> labels = patchLabels(mesh.patches(), "_-.");
  PatchPoints numbering(mesh);
  for (std::size_t p = 0; p < labels.size(); ++p)
  {
    const BoundaryPatch& patch = mesh.patches()[p];
    blocks.addPatch(surfaceOf(grid, mesh, patch, numbering), patch, labels[p]);
  }
  output->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return 1;
}
