// Whatever the worker process does, the host lives on and hears of it.
#include "ErrorCatcher.h"
#include "TestSurfaces.h"

#include "vtkIsotropicTetMesher.h"

#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

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
  void TearDown() override { std::filesystem::remove(this->Script); }

  // Makes a shell script the worker.
  void UseScript(const std::string& body)
  {
    std::ofstream(this->Script) << "#!/bin/sh\n" << body << "\n";
    std::filesystem::permissions(this->Script, std::filesystem::perms::owner_all);
    this->Mesher->SetWorkerExecutable(this->Script.c_str());
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

double secondsSince(std::chrono::steady_clock::time_point began)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
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
  this->UseScript("sleep 100");
  this->Mesher->SetWorkerTimeLimit(0.3);
  const auto began = std::chrono::steady_clock::now();
  EXPECT_TRUE(contains(this->Error(), "time limit"));
  EXPECT_LT(secondsSince(began), 20);
}

TEST_F(Worker, PrintingWithoutEnd)
{
  this->UseScript("yes");
  this->Mesher->SetWorkerTimeLimit(0.3);
  EXPECT_TRUE(contains(this->Error(), "time limit"));
}

TEST_F(Worker, StoppedByTheUser)
{
  this->UseScript("sleep 100");
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  this->Mesher->AddObserver(vtkCommand::ProgressEvent, stop);
  const auto began = std::chrono::steady_clock::now();
  EXPECT_EQ(this->Error(), "");
  EXPECT_LT(secondsSince(began), 20);
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
