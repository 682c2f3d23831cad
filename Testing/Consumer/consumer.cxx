// The chain from a surface to layers, written against the installed package.
#include <vtkCommand.h>
#include <vtkCubeSource.h>
#include <vtkDirectionalEnrichment.h>
#include <vtkIsotropicTetMesher.h>
#include <vtkMeshQualityReport.h>
#include <vtkNew.h>
#include <vtkRANSPointRemoval.h>
#include <vtkUnstructuredGrid.h>

#include <iostream>

int main()
{
  vtkNew<vtkCubeSource> cube;

  vtkNew<vtkIsotropicTetMesher> mesher;
  mesher->AddInputConnection(cube->GetOutputPort());
  mesher->SetMaximumEdgeLength(0.2);

  vtkNew<vtkRANSPointRemoval> removal;
  removal->SetInputConnection(mesher->GetOutputPort());
  removal->AddWallPatch("*");
  removal->SetFirstHeight(1e-3);
  removal->SetNumberOfLayers(5);

  vtkNew<vtkDirectionalEnrichment> enrichment;
  enrichment->SetInputConnection(removal->GetOutputPort());

  vtkNew<vtkMeshQualityReport> report;
  report->SetInputConnection(enrichment->GetOutputPort());
  report->Update();

  const vtkIdType before = mesher->GetOutput()->GetNumberOfCells();
  const vtkIdType after = enrichment->GetOutput()->GetNumberOfCells();
  std::cout << before << " cells became " << after << "\n" << report->GetReportText();
  return before > 0 && after > before ? 0 : 1;
}
