// From a surface to a mesh with boundary layers: pipeline SURFACE.vtp MESH.vtu [FIRST_HEIGHT]
// SURFACE.vtp holds closed bodies; the mesh fills a box around them. Lengths are in the surface's unit.
#include <vtkCallbackCommand.h>
#include <vtkDirectionalEnrichment.h>
#include <vtkIsotropicTetMesher.h>
#include <vtkMeshQualityReport.h>
#include <vtkNew.h>
#include <vtkRANSPointRemoval.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdlib>
#include <iostream>

namespace
{
// Runs one filter; false if it reported an error. VTK's errors are events, not return values.
bool runs(vtkAlgorithm* filter)
{
  bool failed = false;
  vtkNew<vtkCallbackCommand> onError;
  onError->SetClientData(&failed);
  onError->SetCallback(
    [](vtkObject*, unsigned long, void* flag, void* text)
    {
      *static_cast<bool*>(flag) = true;
      std::cerr << static_cast<const char*>(text);
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ErrorEvent, onError);
  filter->Update();
  filter->RemoveObserver(tag);
  return !failed;
}
} // namespace

int main(int count, char* words[])
{
  if (count < 3 || count > 4)
  {
    std::cerr << "usage: pipeline SURFACE.vtp MESH.vtu [FIRST_HEIGHT]\n";
    return 2;
  }
  vtkNew<vtkXMLPolyDataReader> surface;
  surface->SetFileName(words[1]);

  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->SetInputConnection(surface->GetOutputPort());
  mesher->FarFieldOn();
  mesher->SetFarFieldMargins(3, 3, 3, 3, 3, 3); // body lengths

  vtkNew<vtkRANSPointRemoval> removal;
  removal->SetInputConnection(mesher->GetOutputPort());
  removal->SetFirstHeight(count == 4 ? std::atof(words[3]) : 1e-5);

  // Takes the layers that the removal made room for: they travel with the mesh.
  vtkNew<vtkDirectionalEnrichment> enrichment;
  enrichment->SetInputConnection(removal->GetOutputPort());

  vtkNew<vtkMeshQualityReport> report;
  report->SetInputConnection(0, enrichment->GetOutputPort(0));
  report->SetInputConnection(1, enrichment->GetOutputPort(1));

  if (!runs(mesher) || !runs(removal) || !runs(enrichment) || !runs(report))
  {
    return EXIT_FAILURE;
  }
  std::cout << report->GetReportText();

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputConnection(report->GetOutputPort());
  writer->SetFileName(words[2]);
  writer->SetDataModeToBinary(); // some ParaViews cannot read the default, appended
  return writer->Write() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
