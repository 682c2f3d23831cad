#include "vtkIsotropicTetMesher.h"

#include "DomainMeshing.h"
#include "PatchNaming.h"
#include "ProblemOutput.h"
#include "SurfaceInput.h"
#include "WorkerLocation.h"

#include "MeshConversion.h"
#include "StageContext.h"

#include "Boundary/FeatureSplit.h"
#include "Boundary/FlatTriangles.h"
#include "Boundary/SheetAttachment.h"
#include "Boundary/SurfaceCheck.h"
#include "Boundary/SurfaceRemeshing.h"
#include "Boundary/SurfaceSizes.h"
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
#include <array>
#include <optional>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkIsotropicTetMesher);

struct vtkIsotropicTetMesher::Internals
{
  std::vector<ransmesh::SizeBox> Boxes;
  std::vector<ransmesh::SizeSphere> Spheres;
  std::vector<std::pair<std::string, std::string>> TypeOfPattern;
};

namespace
{
// The types that the user did not set and that names do not tell: with a box around them, bodies are walls.
void makeBodiesWalls(ransmesh::PatchTable& patches)
{
  for (std::size_t i = 1; i < patches.size(); ++i)
  {
    if (patches[i].type == ransmesh::PatchType::Patch)
    {
      patches[i].type = ransmesh::PatchType::Wall;
    }
  }
}

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

// A flag a point: whether it lies on a patch of type interface, which must not change.
std::vector<char> frozenPoints(const ransmesh::Domain& domain)
{
  std::vector<char> isFrozen(domain.surface.points.size(), 0);
  for (std::size_t t = 0; t < domain.surface.triangles.size(); ++t)
  {
    if (domain.patches[domain.surface.patch[t]].type == ransmesh::PatchType::Interface)
    {
      for (const ransmesh::Index v : domain.surface.triangles[t])
      {
        isFrozen[v] = 1;
      }
    }
  }
  return isFrozen;
}

std::optional<ransmesh::Extent> extentOfBox(const ransmesh::Domain& domain)
{
  return domain.box ? std::optional(ransmesh::Extent{ domain.box->corners[0], domain.box->corners[7] })
                    : std::nullopt;
}

// Of the space between the bodies and the box, or, without a box, inside the surface.
double domainVolume(const ransmesh::Domain& domain)
{
  const double inside = ransmesh::enclosedVolume(ransmesh::withoutSheets(domain.surface, domain.isSheet));
  const auto box = extentOfBox(domain);
  return box ? box->length(0) * box->length(1) * box->length(2) - inside : inside;
}

ransmesh::FarFieldBox boxAround(
  const ransmesh::SurfaceMesh& bodies, const double margins[6], ransmesh::PatchTable& patches)
{
  std::array<double, 6> six;
  std::copy_n(margins, 6, six.begin());
  return ransmesh::makeFarField(ransmesh::extentOf(bodies.points), six, patches);
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
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkIsotropicTetMesher::~vtkIsotropicTetMesher()
{
  this->SetWorkerExecutable(nullptr);
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "SurfaceEdgeLength: " << this->SurfaceEdgeLength << "\n";
  os << indent << "ImproveSurfaceTriangles: " << this->ImproveSurfaceTriangles << "\n";
  os << indent << "MaximumSurfaceAngle: " << this->MaximumSurfaceAngle << "\n";
  os << indent << "SurfaceGrowthRate: " << this->SurfaceGrowthRate << "\n";
  os << indent << "MaximumRadiusEdgeRatio: " << this->MaximumRadiusEdgeRatio << "\n";
  os << indent << "MinimumDihedralAngle: " << this->MinimumDihedralAngle << "\n";
  os << indent << "FarField: " << this->FarField << "\n";
  os << indent << "FarFieldMargins:";
  for (const double margin : this->FarFieldMargins)
  {
    os << " " << margin;
  }
  os << "\n";
  os << indent << "PatchFromFeatureAngle: " << this->PatchFromFeatureAngle << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Refinement boxes: " << this->Lists->Boxes.size() << "\n";
  os << indent << "Refinement spheres: " << this->Lists->Spheres.size() << "\n";
  os << indent << "Patch types set: " << this->Lists->TypeOfPattern.size() << "\n";
  os << indent << "WorkerExecutable: " << (this->WorkerExecutable ? this->WorkerExecutable : "") << "\n";
  os << indent << "WorkerTimeLimit: " << this->WorkerTimeLimit << "\n";
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
void vtkIsotropicTetMesher::SetPatchType(const char* pattern, const char* typeName)
{
  if (pattern && typeName)
  {
    this->Lists->TypeOfPattern.emplace_back(pattern, typeName);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::ClearPatchTypes()
{
  this->Lists->TypeOfPattern.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::AddSheetData(vtkDataObject* sheets)
{
  this->AddInputDataObject(1, sheets);
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::AddSheetConnection(vtkAlgorithmOutput* sheets)
{
  this->AddInputConnection(1, sheets);
}

//------------------------------------------------------------------------------
void vtkIsotropicTetMesher::RemoveAllSheets()
{
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
int vtkIsotropicTetMesher::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 1);
  return 1;
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
  const auto within = [this](const char* name, double value, double low, double high)
  {
    if (value >= low && value <= high)
    {
      return true;
    }
    vtkErrorMacro(<< name << " is " << value << "; it must lie between " << low << " and " << high << ".");
    return false;
  };
  bool valid = within("MaximumEdgeLength", this->MaximumEdgeLength, 0, 1e50) &&
    within("SurfaceEdgeLength", this->SurfaceEdgeLength, 0, 1e50) &&
    within("MaximumSurfaceAngle", this->MaximumSurfaceAngle, 0, 90) &&
    within("SurfaceGrowthRate", this->SurfaceGrowthRate, 1.01, 3) &&
    within("MaximumRadiusEdgeRatio", this->MaximumRadiusEdgeRatio, 1.1, 10) &&
    within("MinimumDihedralAngle", this->MinimumDihedralAngle, 0, 18) &&
    within("FeatureAngle", this->FeatureAngle, 0, 180) &&
    within("WorkerTimeLimit", this->WorkerTimeLimit, 0, 1e9);
  for (int i = 0; valid && this->FarField && i < 6; ++i)
  {
    valid = within("FarFieldMargins", this->FarFieldMargins[i], 1e-3, 1e4);
  }
  constexpr double smallest = 1e-50;
  for (std::size_t i = 0; valid && i < this->Lists->Boxes.size(); ++i)
  {
    valid = within("The size of a refinement box", this->Lists->Boxes[i].size, smallest, 1e50);
  }
  for (std::size_t i = 0; valid && i < this->Lists->Spheres.size(); ++i)
  {
    valid = within("The size of a refinement sphere", this->Lists->Spheres[i].size, smallest, 1e50);
  }
  return valid;
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
bool vtkIsotropicTetMesher::ReadSurface(
  vtkInformationVector* surfaces, vtkInformationVector* sheets, ransmesh::SurfaceInput& input)
{
  const ransmesh::Outcome outcome = ransmesh::readSurface(dataOf(surfaces), dataOf(sheets), input);
  if (!outcome.ok())
  {
    vtkErrorMacro(<< "Cannot mesh: " << outcome.message << ".");
  }
  return outcome.ok();
}

//------------------------------------------------------------------------------
bool vtkIsotropicTetMesher::Accept(
  const ransmesh::SurfaceVerdict& verdict, const ransmesh::SurfaceMesh& surface, vtkPolyData* problems)
{
  for (const std::string& repair : verdict.repairs)
  {
    vtkWarningMacro("Mended: " << repair << ".");
  }
  if (!verdict.outcome.ok())
  {
    vtkErrorMacro(<< "Cannot mesh: " << verdict.outcome.message << ".");
    ransmesh::writeProblems(surface, verdict.findings, problems);
  }
  return verdict.outcome.ok();
}

//------------------------------------------------------------------------------
bool vtkIsotropicTetMesher::CheckSurface(ransmesh::SurfaceInput& input, vtkPolyData* problems)
{
  const ransmesh::SurfaceVerdict verdict = ransmesh::mendAndCheck(input.surface, input.patches);
  return this->Accept(verdict, input.surface, problems);
}

//------------------------------------------------------------------------------
ransmesh::MeshingOptions vtkIsotropicTetMesher::GetOptions() const
{
  ransmesh::MeshingOptions options;
  options.limits.maximum = this->MaximumEdgeLength;
  options.limits.slope = this->SurfaceGrowthRate - 1;
  options.limits.boxes = this->Lists->Boxes;
  options.limits.spheres = this->Lists->Spheres;
  options.radiusEdgeRatio = this->MaximumRadiusEdgeRatio;
  options.minimumDihedral = this->MinimumDihedralAngle;
  return options;
}

//------------------------------------------------------------------------------
bool vtkIsotropicTetMesher::PrepareSurface(ransmesh::SurfaceInput& input, vtkPolyData* problems)
{
  if (this->PatchFromFeatureAngle)
  {
    for (const int patch : input.wholePieces)
    {
      ransmesh::splitByAngle(input.surface, input.patches, patch, this->FeatureAngle);
    }
  }
  if (this->SurfaceEdgeLength > 0)
  {
    const ransmesh::Outcome outcome =
      ransmesh::remeshSurface(input.surface, this->SurfaceEdgeLength, this->FeatureAngle);
    if (!outcome.ok())
    {
      vtkErrorMacro(<< "Cannot mesh: " << outcome.message << ".");
      return false;
    }
    if (!this->CheckSurface(input, problems))
    {
      vtkErrorMacro("Remeshing to edges of "
        << this->SurfaceEdgeLength
        << " spoiled the surface: details of it are smaller. Choose a smaller SurfaceEdgeLength.");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIsotropicTetMesher::MakeDomain(
  ransmesh::SurfaceInput& input, ransmesh::Domain& domain, vtkPolyData* problems)
{
  if (this->FarField)
  {
    makeBodiesWalls(input.patches);
    domain.box = boxAround(input.surface, this->FarFieldMargins, input.patches);
  }
  input.isSheet.resize(input.patches.size(), 0);
  ransmesh::Outcome outcome = ransmesh::setTypes(this->Lists->TypeOfPattern, input.patches);
  if (outcome.ok())
  {
    outcome = ransmesh::checkSheetTypes(input.patches, input.isSheet);
  }
  if (!outcome.ok())
  {
    vtkErrorMacro(<< "Cannot mesh: " << outcome.message << ".");
    return false;
  }
  domain.surface = std::move(input.surface);
  domain.patches = std::move(input.patches);
  domain.isSheet = std::move(input.isSheet);
  if (input.sheets.triangles.empty())
  {
    return true;
  }
  const ransmesh::SurfaceVerdict verdict =
    ransmesh::attachSheets(domain.surface, std::move(input.sheets), domain.patches, extentOfBox(domain));
  return this->Accept(verdict, domain.surface, problems);
}

//------------------------------------------------------------------------------
ransmesh::FlatTriangleReport vtkIsotropicTetMesher::ImproveTriangles(ransmesh::Domain& domain)
{
  if (!this->ImproveSurfaceTriangles)
  {
    return {};
  }
  const ransmesh::FlatTriangleReport report =
    ransmesh::mendFlatTriangles(domain.surface, this->MaximumSurfaceAngle, frozenPoints(domain));
  if (report.isRefused)
  {
    vtkWarningMacro(
      "No diagonals of surface triangles were swapped, since the surface would cut itself then; "
      "try a smaller MaximumSurfaceAngle.");
  }
  if (report.swaps + report.splits > 0)
  {
    vtkWarningMacro("Mended: " << report.swaps << (report.swaps == 1 ? " diagonal" : " diagonals")
                               << " of surface triangles swapped and " << report.splits
                               << (report.splits == 1 ? " edge" : " edges")
                               << " split, no point moved, no new edge is farther than "
                               << report.largestShift << " from that which it replaced; largest angle "
                               << report.largestBefore << " degrees before, " << report.largestAfter
                               << " after; triangles above " << ransmesh::FlatTriangleAngle
                               << " degrees: " << report.flatBefore << " before, " << report.flatAfter
                               << " after (ImproveSurfaceTriangles off keeps all triangles).");
  }
  return report;
}

//------------------------------------------------------------------------------
bool vtkIsotropicTetMesher::DivideLongEdges(const ransmesh::MeshingOptions& options, ransmesh::Domain& domain)
{
  const auto limit = [&options](const ransmesh::Vector3& x) { return options.limits.at(x); };
  const double wanted = this->MaximumEdgeLength;
  const double tets = wanted > 0 ? 8.5 * domainVolume(domain) / (wanted * wanted * wanted) : 0;
  constexpr double mostTets = 4e8;
  if (tets > mostTets || !ransmesh::halveLongEdges(domain.surface, limit))
  {
    vtkErrorMacro("Cannot mesh: the sizes that are asked for make too large a mesh (more than 400 million "
                  "tetrahedra, or 20 million surface triangles); ask for larger edges.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkIsotropicTetMesher::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* output = vtkUnstructuredGrid::GetData(outputVector, 0);
  auto* problems = vtkPolyData::GetData(outputVector, 1);
  ransmesh::writeProblems({}, {}, problems);
  const std::string program = this->OptionsAreValid() ? this->FindWorker() : "";
  ransmesh::SurfaceInput input;
  if (program.empty() || !this->ReadSurface(inputVector[0], inputVector[1], input))
  {
    return 0;
  }
  // Where the faults can be shown, the pipeline goes on to show them.
  const ransmesh::MeshingOptions options = this->GetOptions();
  ransmesh::Domain domain;
  if (!this->CheckSurface(input, problems) || !this->PrepareSurface(input, problems) ||
    !this->MakeDomain(input, domain, problems))
  {
    return problems->GetNumberOfCells() > 0;
  }
  const ransmesh::TetGenWorker worker(program, this->WorkerTimeLimit);
  const ransmesh::Context context = ransmesh::makeContext(this);
  const ransmesh::Domain asGiven = domain;
  ransmesh::FlatTriangleReport improved = this->ImproveTriangles(domain);
  if (!this->DivideLongEdges(options, domain))
  {
    return 0;
  }
  ransmesh::MeshingResult result;
  ransmesh::Outcome outcome = ransmesh::meshDomain(domain, options, worker, context, result);
  if (!outcome.ok() && outcome.kind != ransmesh::Outcome::Kind::Cancelled &&
    improved.swaps + improved.splits > 0)
  {
    vtkWarningMacro("TetGen does not mesh the mended surface triangles: they are kept as they were given.");
    improved = {};
    result = {};
    domain = asGiven;
    if (!this->DivideLongEdges(options, domain))
    {
      return 0;
    }
    outcome = ransmesh::meshDomain(domain, options, worker, context, result);
  }
  if (outcome.kind == ransmesh::Outcome::Kind::Cancelled)
  {
    return 1; // as the user wished: an empty mesh, no error
  }
  if (!outcome.ok())
  {
    vtkErrorMacro(<< "Cannot mesh: " << outcome.message << ".");
    ransmesh::writeProblems(result.problemSurface, result.problems, problems);
    return !result.problems.empty();
  }
  for (const std::string& remark : result.remarks)
  {
    vtkWarningMacro(<< remark);
  }
  ransmesh::writeMesh(result.mesh, domain.patches, output);
  writeSwitches(result.switches, output);
  writeCount(ransmesh::contract::SurfaceSwaps, improved.swaps, output);
  writeCount(ransmesh::contract::SurfaceSplits, improved.splits, output);
  return 1;
}
