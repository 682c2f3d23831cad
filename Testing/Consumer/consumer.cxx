#include <vtkDirectionalEnrichment.h>
#include <vtkIsotropicTetMesher.h>
#include <vtkMeshQualityReport.h>
#include <vtkNew.h>
#include <vtkRANSPointRemoval.h>
#include <vtkSphereSource.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> body;
  body->SetThetaResolution(40);
  body->SetPhiResolution(20);

  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->SetInputConnection(body->GetOutputPort());
  mesher->FarFieldOn(); // a box around the body is the rest of the boundary

  vtkNew<vtkRANSPointRemoval> removal;
  removal->SetInputConnection(mesher->GetOutputPort());
  removal->SetFirstHeight(1e-4);
  removal->SetNumberOfLayers(20);

  vtkNew<vtkDirectionalEnrichment> enrichment; // makes the layers that the removal made room for
  enrichment->SetInputConnection(removal->GetOutputPort());

  vtkNew<vtkMeshQualityReport> report;
  report->SetInputConnection(enrichment->GetOutputPort());

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputConnection(report->GetOutputPort());
  writer->SetFileName("mesh.vtu");
  writer->SetDataModeToBinary(); // Debian's ParaView cannot read the default, appended
  const bool written = writer->Write() != 0;
  std::cout << report->GetReportText();
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
