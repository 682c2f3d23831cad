// Bodies broken by one mutation each: the diagnosis is right, the triangles that are wrong are marked, and either
// there is a valid mesh, or an error that shows them and whose remedy works.
#include "Bodies/BrokenBodies.h"
#include "Surface/Preparation.h"
#include "Surface/Wrapping.h"
#include "Vtk/BodyPolyData.h"

#include <gtest/gtest.h>

#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkIsotropicTetMesher.h>
#include <vtkMeshQualityReport.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSurfaceWrap.h>
#include <vtkUnstructuredGrid.h>

#include <ostream>
#include <regex>

namespace bodies
{
static void PrintTo(const BrokenBody& broken, std::ostream* out)
{
  *out << broken.name;
}
} // namespace bodies

namespace
{
using bodies::BrokenBody;
using End = BrokenBody::End;

class Broken : public ::testing::TestWithParam<BrokenBody>
{
protected:
  void SetUp() override
  {
    watch_->SetClientData(&errors_);
    watch_->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
      { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
    for (vtkObject* object :
      { static_cast<vtkObject*>(mesher_.Get()), static_cast<vtkObject*>(mesher_->GetExecutive()) })
    {
      object->AddObserver(vtkCommand::ErrorEvent, watch_);
    }
    silence_->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    mesher_->AddObserver(vtkCommand::WarningEvent, silence_);
    mesher_->FarFieldOn();
    mesher_->SetFarFieldMargins(1, 1, 1, 1, 1, 1);
    mesher_->SetWorkerTimeLimit(60);
  }

  // Whether there is a mesh; it is valid then. Else there is an error.
  bool meshes()
  {
    errors_.clear();
    mesher_->Modified();
    mesher_->Update();
    if (mesher_->GetOutput()->GetNumberOfCells() == 0)
    {
      EXPECT_NE(errors_, "");
      return false;
    }
    EXPECT_EQ(errors_, "");
    vtkNew<vtkMeshQualityReport> report;
    report->SetInputData(mesher_->GetOutput());
    report->Update();
    EXPECT_TRUE(report->GetValid());
    return true;
  }

  // The number that follows the option in the message.
  double proposed(const std::string& option) const
  {
    std::smatch match;
    const bool found = std::regex_search(errors_, match, std::regex("ransmesh " + option + " ([-+.e0-9]+)"));
    EXPECT_TRUE(found) << errors_;
    return found ? std::stod(match[1]) : 0;
  }

  void wrap(vtkPolyData* surface)
  {
    vtkNew<vtkSurfaceWrap> wrap;
    wrap->AddObserver(vtkCommand::WarningEvent, silence_);
    wrap->SetInputData(surface);
    wrap->SetAlpha(5 * proposed("--wrap")); // coarser than proposed: tests are to be quick
    wrap->Update();
    mesher_->SetInputDataObject(wrap->GetOutput());
  }

  int problems() const
  {
    return static_cast<int>(vtkPolyData::SafeDownCast(mesher_->GetOutputDataObject(1))->GetNumberOfCells());
  }

  vtkNew<vtkIsotropicTetMesher> mesher_;
  vtkNew<vtkCallbackCommand> watch_;
  vtkNew<vtkCallbackCommand> silence_;
  std::string errors_;
};
} // namespace

TEST_P(Broken, IsDiagnosed)
{
  const BrokenBody& broken = GetParam();
  const ransmesh::Diagnosis diagnosis = ransmesh::diagnose(broken.body.surface, {}, {});
  const ransmesh::Fault* fault = diagnosis.find(broken.fault);
  ASSERT_TRUE(fault);
  if (broken.count > 0)
  {
    EXPECT_EQ(fault->count, broken.count);
  }
  EXPECT_GT(fault->count, 0u);
  std::set<ransmesh::Index> marked;
  for (const ransmesh::SurfaceFinding& finding : fault->findings)
  {
    marked.insert(finding.triangle);
  }
  EXPECT_TRUE(std::includes(marked.begin(), marked.end(), broken.mustMark.begin(), broken.mustMark.end()));
  if (broken.marksNoOthers)
  {
    EXPECT_EQ(marked, broken.mustMark);
  }
}

TEST_P(Broken, IsMeshedOrRefusedWithARemedyThatWorks)
{
  const BrokenBody& broken = GetParam();
  const auto surface = bodies::toPolyData(broken.body);
  mesher_->SetInputDataObject(surface);
  const bool done = meshes();
  if (broken.end == End::MeshedOrRefused)
  {
    EXPECT_TRUE(done || problems() > 0) << errors_;
    return;
  }
  ASSERT_EQ(done, broken.end == End::Meshed) << errors_;
  if (done)
  {
    return;
  }
  EXPECT_GT(problems(), 0);
  if (broken.end == End::Welded)
  {
    mesher_->SetWeldTolerance(proposed("--weld"));
  }
  if (broken.end == End::Filled)
  {
    mesher_->SetLargestHole(proposed("--fill-holes"));
  }
  if (broken.end == End::Wrapped)
  {
    wrap(surface);
  }
  if (broken.end != End::Refused)
  {
    EXPECT_TRUE(meshes()) << errors_;
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, Broken, ::testing::ValuesIn(bodies::brokenBodies()),
  [](const ::testing::TestParamInfo<BrokenBody>& tested)
  {
    std::string name = tested.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  });
