// Bodies whose layers become prisms: the mesh stays conforming, every corner positive, and most of the layers
// are wedges.
#include "Bodies/Cases.h"
#include "TestName.h"
#include "Vtk/ChainRun.h"

#include <vtkMeshQualityReport.h>
#include <vtkNew.h>
#include <vtkPrismRecombination.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <ostream>

namespace
{
struct Subject
{
  const char* name;
  double leastShare; // of the layers' tetrahedra that become wedges and hexahedra
};

// Grids in concave corners become hexahedra; fans end in tetrahedra at their feet.
constexpr Subject subjects[] = { { "plate", 1 }, { "plate-noise", 1 }, { "sphere", 1 }, { "pipe", 1 },
  { "wing", 0.95 }, { "cube", 0.95 }, { "cone", 0.95 }, { "wing-wake", 0.95 }, { "fin-thin", 0.9 },
  { "cavity-six", 0.99 }, { "corner", 0.99 }, { "half-dome", 0.95 }, { "channel-gap0.5", 0.85 } };

void PrintTo(const Subject& subject, std::ostream* out)
{
  *out << subject.name;
}

class Prisms : public testing::TestWithParam<Subject>
{
};
} // namespace

TEST_P(Prisms, AreValidAndMostOfTheLayers)
{
  const bodies::Case* c = bodies::findCase(GetParam().name);
  ASSERT_TRUE(c);
  const bodies::Layers layers = c->layers(c->testSize);
  const bodies::Body body = c->make(c->testSize, layers);
  vtkNew<vtkPrismRecombination> recombination;
  recombination->SetInputData(chain_run::runChain(body, chain_run::optionsFor(*c, layers, body)).mesh);
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputConnection(recombination->GetOutputPort());
  report->Update();
  EXPECT_TRUE(report->GetValid()) << report->GetReportText();
  EXPECT_GE(recombination->GetShareOfLayers(), GetParam().leastShare);
  EXPECT_GT(recombination->GetNumberOfWedges(), 0);
}

INSTANTIATE_TEST_SUITE_P(Layers, Prisms, testing::ValuesIn(subjects), testName<Subject>);
