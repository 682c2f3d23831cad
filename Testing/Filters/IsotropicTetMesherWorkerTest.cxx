// Whatever the worker process does, the host lives on and hears of it.
#include "ErrorCatcher.h"
#include "TestSurfaces.h"

#include "vtkIsotropicTetMesher.h"

#include "Support/DataContract.h"

#include "vtkFieldData.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

namespace
{
class Worker : public ::testing::Test
{
protected:
  vtkNew<vtkIsotropicTetMesher> Mesher;
  std::filesystem::path Script;

  void SetUp() override
  {
    this->Script =
      std::filesystem::temp_directory_path() / ("ransmesh-worker-test-" + std::to_string(getpid()) + ".sh");
    this->Mesher->SetInputDataObject(TestSurfaces::Sphere(1, 12));
  }
  void TearDown() override
  {
    std::filesystem::remove(this->Script);
    std::filesystem::remove(this->Script.string() + ".runs");
  }

  // Makes a shell script the worker.
  void UseScript(const std::string& body)
  {
    std::ofstream(this->Script) << "#!/bin/sh\n" << body << "\n";
    std::filesystem::permissions(this->Script, std::filesystem::perms::owner_all);
    this->Mesher->SetWorkerExecutable(this->Script.c_str());
  }

  // A worker that gives up the first times, and then does what it should. `first`: its status the very first time.
  std::string FailingAtFirst(int times, int first = 43) const
  {
    const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "ransmesh-tetgen-worker";
    const std::string runs = this->Script.string() + ".runs";
    std::filesystem::remove(runs);
    return "echo run >> " + runs + "\nif [ $(wc -l < " + runs + ") -le 1 ]; then exit " +
      std::to_string(first) + "; fi\nif [ $(wc -l < " + runs + ") -le " + std::to_string(times) +
      " ]; then exit 43; fi\nexec " + program.string() + " \"$@\"";
  }

  // The warnings on the way to a mesh.
  std::string Warning()
  {
    WarningCatcher warnings(this->Mesher);
    this->Mesher->Update();
    EXPECT_GT(this->Mesher->GetOutput()->GetNumberOfCells(), 0);
    return warnings.GetText();
  }

  std::string Switches()
  {
    return vtkStringArray::SafeDownCast(
      this->Mesher->GetOutput()->GetFieldData()->GetAbstractArray(ransmesh::contract::MesherSwitches))
      ->GetValue(0);
  }

  // A worker that hangs. Where it is waited for all the same, it counts as a run.
  void UseHangingScript() { this->UseScript("sleep 100; echo run >> " + this->Script.string() + ".runs"); }

  // How often it was called.
  int Runs() const
  {
    std::ifstream runs(this->Script.string() + ".runs");
    return static_cast<int>(std::count(std::istreambuf_iterator<char>(runs), {}, '\n'));
  }

  double Count(const char* name)
  {
    return this->Mesher->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0);
  }

  std::string Error()
  {
    ErrorCatcher errors(this->Mesher);
    this->Mesher->Update();
    EXPECT_EQ(this->Mesher->GetOutput()->GetNumberOfCells(), 0);
    return errors.GetText();
  }
};

bool contains(const std::string& text, const char* phrase)
{
  return text.find(phrase) != std::string::npos;
}

// One side is cut into a needle and a cap, which the mesher betters.
vtkSmartPointer<vtkPolyData> obtuseCube()
{
  return TestSurfaces::Triangles({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                                   { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { 0.5, 0.49, 1 } },
    { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 5 }, { 0, 5, 4 }, { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 },
      { 3, 0, 4 }, { 3, 4, 7 }, { 4, 5, 8 }, { 5, 6, 8 }, { 4, 8, 6 }, { 4, 6, 7 } });
}
} // namespace

TEST_F(Worker, Missing)
{
  this->Mesher->SetWorkerExecutable("/nowhere/worker");
  EXPECT_TRUE(contains(this->Error(), "was not found (tried: /nowhere/worker)"));
}

TEST_F(Worker, Crashing)
{
  this->UseScript("echo assertion failed in line 7 >&2; kill -SEGV $$");
  const std::string text = this->Error();
  EXPECT_TRUE(contains(text, "crashed"));
  EXPECT_TRUE(contains(text, "assertion failed in line 7"));
}

TEST_F(Worker, Aborting)
{
  this->UseScript("kill -ABRT $$");
  EXPECT_TRUE(contains(this->Error(), "crashed"));
}

TEST_F(Worker, GivingUpWithTetGensCode)
{
  this->UseScript("echo Found two facets intersect each other.; exit 43");
  const std::string text = this->Error();
  EXPECT_TRUE(contains(text, "TetGen gave up with error 3"));
  EXPECT_TRUE(contains(text, "two facets intersect"));
}

TEST_F(Worker, SayingNothing)
{
  this->UseScript("exit 0");
  EXPECT_TRUE(contains(this->Error(), "left no readable result"));
}

TEST_F(Worker, LeavingGarbage)
{
  this->UseScript("head -c 100000 /dev/urandom > \"$2\"; head -c 100000 /dev/urandom");
  EXPECT_TRUE(contains(this->Error(), "left no readable result"));
}

TEST_F(Worker, LeavingAMeshThatIsCutShort)
{
  vtkNew<vtkIsotropicTetMesher> sound; // the default worker is found
  sound->SetInputDataObject(TestSurfaces::Sphere(1, 12));
  sound->Update();
  EXPECT_GT(sound->GetOutput()->GetNumberOfCells(), 0);
  this->UseScript("head -c 500 \"$1\" > \"$2\"");
  EXPECT_TRUE(contains(this->Error(), "left no readable result"));
}

TEST_F(Worker, Hanging)
{
  this->UseHangingScript();
  this->Mesher->SetWorkerTimeLimit(0.3);
  EXPECT_TRUE(contains(this->Error(), "time limit"));
  EXPECT_EQ(this->Runs(), 0);
}

TEST_F(Worker, PrintingWithoutEnd)
{
  this->UseScript("yes");
  this->Mesher->SetWorkerTimeLimit(0.3);
  EXPECT_TRUE(contains(this->Error(), "time limit"));
}

TEST_F(Worker, StoppedByTheUser)
{
  this->UseHangingScript();
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  this->Mesher->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(this->Error(), "");
  EXPECT_EQ(this->Runs(), 0);
}

TEST_F(Worker, IsTriedWithAFinerTolerance)
{
  this->UseScript(this->FailingAtFirst(1));
  EXPECT_TRUE(contains(this->Warning(), "needed more than one attempt and succeeded with the switches pq"));
  EXPECT_TRUE(contains(this->Switches(), "YT1e-12"));
}

TEST_F(Worker, IsTriedWithACoarserTolerance)
{
  this->UseScript(this->FailingAtFirst(2));
  EXPECT_TRUE(contains(this->Warning(), "succeeded with the switches pq"));
  EXPECT_TRUE(contains(this->Switches(), "YT1e-6"));
}

TEST_F(Worker, GoingRoundForEverIsToldFromOtherFailures)
{
  this->UseScript("exit 6");
  EXPECT_TRUE(contains(this->Error(), "does not come to an end with the surface"));
}

TEST_F(Worker, GetsTheSurfaceAsGivenWhereItDoesNotMeshTheMendedOne)
{
  this->Mesher->SetInputDataObject(obtuseCube());
  this->Mesher->Update();
  EXPECT_GT(this->Count(ransmesh::contract::SurfaceSwaps), 0);
  // Every switch fails on the mended surface.
  this->UseScript(this->FailingAtFirst(4));
  EXPECT_TRUE(contains(this->Warning(), "they are kept as they were given"));
  EXPECT_EQ(this->Count(ransmesh::contract::SurfaceSwaps), 0);
  EXPECT_EQ(this->Count(ransmesh::contract::SurfaceSplits), 0);
}

TEST_F(Worker, RefiningWithoutEndIsNotLeftToRefineAgain)
{
  this->Mesher->SetInputDataObject(obtuseCube());
  this->UseScript(
    this->FailingAtFirst(2, 5)); // without end; then, without refining, the mended surface fails
  const std::string warning = this->Warning();
  EXPECT_TRUE(contains(warning, "made without refining")) << warning;
  EXPECT_TRUE(contains(warning, "--surface-size")) << warning;
  EXPECT_TRUE(contains(this->Switches(), "D1"));
  EXPECT_EQ(this->Runs(), 3);
}

TEST_F(Worker, FailingAlwaysShowsNearSheets)
{
  this->UseScript("exit 43");
  EXPECT_FALSE(contains(this->Error(), "nearly touch")); // of the sphere
  vtkSmartPointer<vtkPolyData> upper = TestSurfaces::Cube(0, 1);
  vtkNew<vtkTransform> move;
  move->Translate(0, 0.1, 1.00005);
  vtkNew<vtkTransformPolyDataFilter> moved;
  moved->SetTransform(move);
  moved->SetInputData(upper);
  moved->Update();
  this->Mesher->SetInputDataObject(TestSurfaces::Together({ TestSurfaces::Cube(0, 1), moved->GetOutput() }));
  const std::string text = this->Error();
  EXPECT_TRUE(contains(text, "TetGen gave up with error 3"));
  EXPECT_TRUE(contains(text, "so did 3 attempts"));
  EXPECT_TRUE(contains(text, "nearly touch"));
  EXPECT_GE(vtkPolyData::SafeDownCast(this->Mesher->GetOutputDataObject(1))->GetNumberOfCells(), 2);
}

TEST_F(Worker, NeedingMoreMemoryThanTheLimit)
{
  this->Mesher->SetWorkerMemoryLimit(20);
  const std::string text = this->Error();
  EXPECT_TRUE(contains(text, "limit of 20 MB (WorkerMemoryLimit)")) << text;
  EXPECT_FALSE(contains(text, "attempts")) << text;
  this->Mesher->SetWorkerMemoryLimit(2000);
  this->Mesher->Update();
  EXPECT_GT(this->Mesher->GetOutput()->GetNumberOfCells(), 0);
}

TEST_F(Worker, ReportsProgress)
{
  double last = -1;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&last);
  watch->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* seen = static_cast<double*>(data);
      const double now = static_cast<vtkAlgorithm*>(caller)->GetProgress();
      EXPECT_GE(now, *seen);
      *seen = now;
    });
  this->Mesher->AddObserver(vtkCommand::ProgressEvent, watch);
  this->Mesher->Update();
  EXPECT_GT(this->Mesher->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_GT(last, 0.5);
}
