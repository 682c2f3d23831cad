// Catches the error or warning events of an algorithm and its executive, so that a test can read them.
#ifndef ErrorCatcher_h
#define ErrorCatcher_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

class MessageCatcher
{
public:
  MessageCatcher(vtkAlgorithm* algorithm, vtkCommand::EventIds event)
    : Algorithm(algorithm)
  {
    this->Command->SetClientData(&this->Text);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
      { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
    algorithm->AddObserver(event, this->Command);
    algorithm->GetExecutive()->AddObserver(event, this->Command);
  }
  ~MessageCatcher()
  {
    this->Algorithm->RemoveObserver(this->Command);
    this->Algorithm->GetExecutive()->RemoveObserver(this->Command);
  }
  MessageCatcher(const MessageCatcher&) = delete;
  void operator=(const MessageCatcher&) = delete;

  // All messages so far; empty if there was none.
  const std::string& GetText() const { return this->Text; }
  bool Says(const char* phrase) const { return this->Text.find(phrase) != std::string::npos; }

private:
  vtkSmartPointer<vtkAlgorithm> Algorithm;
  vtkNew<vtkCallbackCommand> Command;
  std::string Text;
};

struct ErrorCatcher : MessageCatcher
{
  explicit ErrorCatcher(vtkAlgorithm* algorithm)
    : MessageCatcher(algorithm, vtkCommand::ErrorEvent)
  {
  }
};

struct WarningCatcher : MessageCatcher
{
  explicit WarningCatcher(vtkAlgorithm* algorithm)
    : MessageCatcher(algorithm, vtkCommand::WarningEvent)
  {
  }
};

#endif
