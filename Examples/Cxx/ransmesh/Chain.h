// The filters in a row, run one after the other so that each one's failure is told from the next one's.
#pragma once

#include "Messages.h"
#include "Options.h"
#include "Progress.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <stdexcept>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDirectionalEnrichment;
class vtkIsotropicTetMesher;
class vtkMeshAdoption;
class vtkMeshQualityReport;
class vtkPolyData;
class vtkPrismRecombination;
class vtkRANSLayerAlgorithm;
class vtkRANSPointRemoval;
class vtkSurfaceWrap;
class vtkUnstructuredGrid;

namespace commandline
{
// The input cannot be meshed: what() says why and where, in one line.
struct MeshingError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

struct StageTime
{
  std::string name;
  double seconds;
};

class Chain
{
public:
  // input: surfaces, or a mesh if the options say so. sheets: inside the domain; may be null.
  Chain(const Options& options, vtkDataObject* input, vtkPolyData* sheets);
  ~Chain();

  // Throws MeshingError.
  void run();

  vtkUnstructuredGrid* mesh() const;
  // What was asked of the layers.
  vtkRANSLayerAlgorithm* layers() const;
  vtkMeshQualityReport* report() const;
  // The triangles that are wrong with the surface; may be empty.
  vtkPolyData* problems() const;
  const std::vector<StageTime>& times() const { return times_; }
  const std::vector<std::string>& warnings() const { return messages_->warnings(); }

private:
  vtkAlgorithm* isotropicMesh() const;
  void describeSurfaces();
  void describeRepair();
  void describeDomain();
  void describePatches();
  void describePlanes();
  void describeFlow();
  void describeLayers();
  void describeColumns();
  void runStage(const std::string& name, vtkAlgorithm* filter);

  const Options& options_;
  vtkNew<vtkSurfaceWrap> wrap_;
  vtkNew<vtkIsotropicTetMesher> mesher_;
  vtkNew<vtkMeshAdoption> adoption_; // in the mesher's place
  vtkNew<vtkRANSPointRemoval> removal_;
  vtkNew<vtkDirectionalEnrichment> enrichment_;
  vtkNew<vtkPrismRecombination> recombination_;
  vtkNew<vtkMeshQualityReport> report_;
  vtkNew<Messages> messages_;
  vtkNew<Progress> progress_;
  std::vector<StageTime> times_;
};
} // namespace commandline
