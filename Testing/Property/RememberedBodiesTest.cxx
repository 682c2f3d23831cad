// Bodies that once failed, as random runs wrote them to files.
#include "TestName.h"
#include "Vtk/ChainRun.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <string>

namespace
{
struct Remembered
{
  std::string name; // of the file
  double firstHeight;
  double growth;
  int layers;
  bool farField;
  std::optional<double> symmetryPlace; // as in ChainOptions
};

void PrintTo(const Remembered& body, std::ostream* out)
{
  *out << body.name;
}

const Remembered all[] = {
  // TetGen walks round for ever at its usual tolerance of coplanarity, and at a finer one.
  { "plane-but-for-rounding", 2.36, 1.026, 23, true, {} },
  // Cut by the plane of symmetry: TetGen dies where the plane's polygon does not begin with its outermost points.
  { "flat-body-cut", 0.039, 1.01, 29, true, -59693.109840332247 },
};

class RememberedBodies : public testing::TestWithParam<Remembered>
{
};
} // namespace

TEST_P(RememberedBodies, GiveValidMeshes)
{
  const Remembered& body = GetParam();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((std::string(REMEMBERED_BODIES) + "/" + body.name + ".vtp").c_str());
  reader->Update();
  ASSERT_GT(reader->GetOutput()->GetNumberOfCells(), 0);
  chain_run::ChainOptions options;
  options.firstHeight = body.firstHeight;
  options.growth = body.growth;
  options.layers = body.layers;
  options.farField = body.farField;
  options.symmetryPlace = body.symmetryPlace;
  const chain_run::ChainResult result = chain_run::runChain(reader->GetOutput(), options);
  EXPECT_EQ(result.faults, "");
  EXPECT_GT(result.inserted, 0);
}

INSTANTIATE_TEST_SUITE_P(Property, RememberedBodies, testing::ValuesIn(all), testName<Remembered>);
