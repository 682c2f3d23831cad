// Catches the error events of an algorithm and its executive, so that a test can read them.
#ifndef ErrorCatcher_h
#define ErrorCatcher_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

class ErrorCatcher
{
public:
  explicit ErrorCatcher(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
    this->Command->SetClientData(&this->Text);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
      { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
    algorithm->AddObserver(vtkCommand::ErrorEvent, this->Command);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~ErrorCatcher()
  {
    this->Algorithm->RemoveObserver(this->Command);
    this->Algorithm->GetExecutive()->RemoveObserver(this->Command);
  }
  ErrorCatcher(const ErrorCatcher&) = delete;
  void operator=(const ErrorCatcher&) = delete;

  // All messages so far; empty if there was no error.
  const std::string& GetText() const { return this->Text; }
  bool Says(const char* phrase) const { return this->Text.find(phrase) != std::string::npos; }

private:
  vtkSmartPointer<vtkAlgorithm> Algorithm;
  vtkNew<vtkCallbackCommand> Command;
  std::string Text;
};

#endif
