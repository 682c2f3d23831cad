#include "Messages.h"

#include "OptionNames.h"

#include <vtkAlgorithm.h>
#include <vtkExecutive.h>

#include <algorithm>

namespace commandline
{
namespace
{
// VTK writes "ERROR: In <file>, line <n>\n<class> (<address>): <text>\n\n".
std::string textOf(const char* report)
{
  std::string text = report ? report : "";
  const std::size_t address = text.find(" (0x");
  const std::size_t end = address == std::string::npos ? address : text.find("): ", address);
  if (end != std::string::npos)
  {
    text.erase(0, end + 3);
  }
  text.erase(text.find_last_not_of(" \n\r\t") + 1);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}
} // namespace

void Messages::watch(vtkAlgorithm* algorithm)
{
  // The executive repeats that a filter failed; its report is taken so that it is not printed.
  algorithm->AddObserver(vtkCommand::ErrorEvent, this);
  algorithm->AddObserver(vtkCommand::WarningEvent, this);
  algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this);
}

void Messages::Execute(vtkObject* caller, unsigned long event, void* data)
{
  const std::string text =
    withOptionNames(textOf(static_cast<const char*>(data)), caller->IsA("vtkRANSLayerAlgorithm") != 0);
  (event == vtkCommand::ErrorEvent ? errors_ : warnings_).push_back(text);
}
} // namespace commandline
