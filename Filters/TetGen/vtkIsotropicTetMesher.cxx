#include "vtkIsotropicTetMesher.h"

#include "DomainPreparation.h"
#include "DomainRefinement.h"
#include "ProblemOutput.h"
#include "WorkerLocation.h"

#include "MeshConversion.h"
#include "OptionRange.h"
#include "RegionArrays.h"
#include "StageContext.h"

#include "Mesh/Regions.h"
#include "Support/DataContract.h"

#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkIsotropicTetMesher);

struct vtkIsotropicTetMesher::Internals
{
  std::vector<ransmesh::SizeBox> Boxes;
  std::vector<ransmesh::SizeSphere> Spheres;
  std::vector<ransmesh::SizeLine> Lines;
  std::vector<std::pair<std::string, double>> LengthOfPattern;
};

namespace
{
void writeSwitches(const std::string& switches, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkStringArray> array;
  array->SetName(ransmesh::contract::MesherSwitches);
  array->InsertNextValue(switches);
  grid->GetFieldData()->AddArray(array);
}

void writeCount(const char* name, std::size_t count, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->InsertNextValue(static_cast<vtkIdType>(count));
  grid->GetFieldData()->AddArray(array);
}

std::vector<vtkDataObject*> dataOf(vtkInformationVector* inputs)
{
  std::vector<vtkDataObject*> data;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    data.push_back(vtkDataObject::GetData(inputs, i));
  }
  return data;
}
} // namespace

//------------------------------------------------------------------------------
vtkIsotropicTetMesher::vtkIsotropicTetMesher()
  : Lists(new Internals)
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkIsotropicTetMesher::~vtkIsotropicTetMesher()
{
  this->SetWorkerExecutable(nullptr);
  this->SetSurfaceSizeArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "SurfaceEdgeLength: " << this->SurfaceEdgeLength << "\n";
  os << indent << "Patch edge lengths: " << this->Lists->LengthOfPattern.size() << "\n";
  os << indent << "EdgesPerCircle: " << this->EdgesPerCircle << "\n";
  os << indent << "EdgesAcrossGap: " << this->EdgesAcrossGap << "\n";
  os << indent << "SmallestSurfaceEdgeLength: " << this->SmallestSurfaceEdgeLength << "\n";
  os << indent << "MaximumSurfaceDeviation: " << this->MaximumSurfaceDeviation << "\n";
  os << indent << "SurfaceSizeArray: " << (this->SurfaceSizeArray ? this->SurfaceSizeArray : "") << "\n";
  os << indent << "ImproveSurfaceTriangles: " << this->ImproveSurfaceTriangles << "\n";
  os << indent << "MaximumSurfaceAngle: " << this->MaximumSurfaceAngle << "\n";
  os << indent << "SurfaceGrowthRate: " << this->SurfaceGrowthRate << "\n";
  os << indent << "MaximumRadiusEdgeRatio: " << this->MaximumRadiusEdgeRatio << "\n";
  os << indent << "MinimumDihedralAngle: " << this->MinimumDihedralAngle << "\n";
  os << indent << "Refinement boxes: " << this->Lists->Boxes.size() << "\n";
  os << indent << "Refinement spheres: " << this->Lists->Spheres.size() << "\n";
  os << indent << "Refinement lines: " << this->Lists->Lines.size() << "\n";
  os << indent << "WorkerExecutable: " << (this->WorkerExecutable ? this->WorkerExecutable : "") << "\n";
  os << indent << "WorkerTimeLimit: " << this->WorkerTimeLimit << "\n";
  os << indent << "WorkerMemoryLimit: " << this->WorkerMemoryLimit << "\n";
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::AddRefinementBox(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax, double size)
{
  this->Lists->Boxes.push_back({ { xmin, ymin, zmin }, { xmax, ymax, zmax }, size });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::AddRefinementSphere(double cx, double cy, double cz, double radius, double size)
{
  this->Lists->Spheres.push_back({ { cx, cy, cz }, radius, size });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::ClearRefinements()
{
  this->ClearRefinementBoxes();
  this->ClearRefinementSpheres();
  this->ClearRefinementLines();
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::ClearRefinementBoxes()
{
  this->Lists->Boxes.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::ClearRefinementSpheres()
{
  this->Lists->Spheres.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::AddRefinementLine(
  double x1, double y1, double z1, double x2, double y2, double z2, double radius, double size)
{
  this->Lists->Lines.push_back({ { x1, y1, z1 }, { x2, y2, z2 }, radius, size });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::ClearRefinementLines()
{
  this->Lists->Lines.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::SetPatchEdgeLength(const char* pattern, double length)
{
  if (pattern && length > 0)
  {
    this->Lists->LengthOfPattern.emplace_back(pattern, length);
    this->Modified();
    return;
  }
  vtkErrorMacro("SetPatchEdgeLength needs the name of a patch and a length above 0.");
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::ClearPatchEdgeLengths()
{
  this->Lists->LengthOfPattern.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkIsotropicTetMesher::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
bool vtkIsotropicTetMesher::OptionsAreValid()
{
  constexpr double largest = ransmesh::LargestLength;
  std::vector<ransmesh::OptionRange> ranges = { { "MaximumEdgeLength", this->MaximumEdgeLength, 0, largest },
    { "SurfaceEdgeLength", this->SurfaceEdgeLength, 0, largest },
    { "EdgesPerCircle", this->EdgesPerCircle, 0, 1e4 }, { "EdgesAcrossGap", this->EdgesAcrossGap, 0, 1e3 },
    { "SmallestSurfaceEdgeLength", this->SmallestSurfaceEdgeLength, 0, largest },
    { "MaximumSurfaceDeviation", this->MaximumSurfaceDeviation, 0, largest },
    { "MaximumSurfaceAngle", this->MaximumSurfaceAngle, 0, 90 },
    { "SurfaceGrowthRate", this->SurfaceGrowthRate, 1.01, 3 },
    { "MaximumRadiusEdgeRatio", this->MaximumRadiusEdgeRatio, 1.1, 10 },
    { "MinimumDihedralAngle", this->MinimumDihedralAngle, 0, 18 },
    { "WorkerTimeLimit", this->WorkerTimeLimit, 0, 1e9 },
    { "WorkerMemoryLimit", this->WorkerMemoryLimit, 0, 1e9 } };
  const auto addSizes = [&](const char* name, const auto& refinements)
  {
    for (const auto& refinement : refinements)
    {
      ranges.push_back({ name, refinement.size, 1 / largest, largest });
    }
  };
  addSizes("The size of a refinement box", this->Lists->Boxes);
  addSizes("The size of a refinement sphere", this->Lists->Spheres);
  addSizes("The size of a refinement line", this->Lists->Lines);
  ransmesh::Outcome outcome = ransmesh::checkRanges(ranges);
  outcome = outcome.ok() ? this->CheckDomainOptions() : outcome;
  if (!outcome.ok())
  {
    vtkErrorMacro(<< outcome.message << ".");
  }
  return outcome.ok();
}

//------------------------------------------------------------------------------
std::string vtkIsotropicTetMesher::FindWorker()
{
  std::string tried;
  const std::string program =
    ransmesh::findWorker(this->WorkerExecutable ? this->WorkerExecutable : "", tried);
  if (program.empty())
  {
    vtkErrorMacro("The program that runs TetGen was not found (tried: "
      << tried << "). Set WorkerExecutable or the environment variable RANSMESH_WORKER.");
  }
  return program;
}

//------------------------------------------------------------------------------
ransmesh::MesherSettings vtkIsotropicTetMesher::GetSettings() const
{
  ransmesh::MesherSettings settings;
  this->DescribeDomain(settings);
  ransmesh::RemeshingOptions& remeshing = settings.sizing.general;
  remeshing.length = this->SurfaceEdgeLength;
  remeshing.edgesPerCircle = this->EdgesPerCircle;
  remeshing.edgesAcrossGap = this->EdgesAcrossGap;
  remeshing.gapSide = this->FarField ? ransmesh::GapSide::Outside : ransmesh::GapSide::Inside;
  remeshing.smallest = this->SmallestSurfaceEdgeLength;
  remeshing.slope = this->SurfaceGrowthRate - 1;
  remeshing.deviation = this->MaximumSurfaceDeviation;
  remeshing.featureAngle = this->FeatureAngle;
  settings.sizing.lengthOfPattern = this->Lists->LengthOfPattern;
  settings.improveTriangles = this->ImproveSurfaceTriangles;
  settings.surfaceAngle = this->MaximumSurfaceAngle;
  settings.meshing.limits.maximum = this->MaximumEdgeLength;
  settings.meshing.limits.slope = this->SurfaceGrowthRate - 1;
  settings.meshing.limits.boxes = this->Lists->Boxes;
  settings.meshing.limits.spheres = this->Lists->Spheres;
  settings.meshing.limits.lines = this->Lists->Lines;
  settings.meshing.radiusEdgeRatio = this->MaximumRadiusEdgeRatio;
  settings.meshing.minimumDihedral = this->MinimumDihedralAngle;
  return settings;
}

//------------------------------------------------------------------------------
int vtkIsotropicTetMesher::Refuse(
  const ransmesh::Outcome& outcome, const ransmesh::MesherReport& report, vtkPolyData* problems)
{
  if (outcome.kind == ransmesh::Outcome::Kind::Cancelled)
  {
    return 1; // as the user wished: an empty mesh, no error
  }
  vtkErrorMacro(<< "Cannot mesh: " << outcome.message << ".");
  ransmesh::writeProblems(report.problemSurface, report.problems, problems);
  return !report.problems.empty(); // where the faults can be shown, the pipeline goes on to show them
}

//------------------------------------------------------------------------------
int vtkIsotropicTetMesher::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkUnstructuredGrid::GetData(outputVector, 0);
  auto* problems = vtkPolyData::GetData(outputVector, 1);
  ransmesh::writeProblems({}, {}, problems);
  const std::string program = this->OptionsAreValid() ? this->FindWorker() : "";
  if (program.empty())
  {
    return 0;
  }
  ransmesh::MesherReport report;
  report.remark = [this](const std::string& text) { vtkWarningMacro(<< text); };

  ransmesh::SurfaceInput input;
  ransmesh::Outcome outcome = ransmesh::readSurface(dataOf(inputVector[0]), dataOf(inputVector[1]), input);
  if (!outcome.ok())
  {
    return this->Refuse(outcome, report, problems);
  }
  ransmesh::MesherSettings settings = this->GetSettings();
  if (this->SurfaceSizeArray && *this->SurfaceSizeArray)
  {
    outcome = ransmesh::readLengthsAtPoints(dataOf(inputVector[0]), this->SurfaceSizeArray, settings.sizing);
    if (!outcome.ok())
    {
      return this->Refuse(outcome, report, problems);
    }
  }
  ransmesh::Domain domain;
  outcome = ransmesh::prepareDomain(settings, std::move(input), domain, report);
  if (!outcome.ok())
  {
    return this->Refuse(outcome, report, problems);
  }
  const ransmesh::TetGenWorker worker(program, { this->WorkerTimeLimit, this->WorkerMemoryLimit });
  ransmesh::DomainMesh made;
  outcome = ransmesh::refineAndMesh(settings, domain, worker, ransmesh::makeContext(this), made, report);
  if (!outcome.ok())
  {
    return this->Refuse(outcome, report, problems);
  }
  ransmesh::writeMesh(made.mesh, domain.patches, output);
  ransmesh::writeRegions(ransmesh::numberRegions(made.mesh), output);
  writeSwitches(made.switches, output);
  writeCount(ransmesh::contract::SurfaceSwaps, made.triangles.swaps, output);
  writeCount(ransmesh::contract::SurfaceSplits, made.triangles.splits, output);
  return 1;
}
