// The errors and warnings of VTK objects, kept instead of printed.
#pragma once

#include <vtkCommand.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkAlgorithm;

namespace commandline
{
// Collects what the objects it watches report, one line each, without VTK's "ERROR: In file ...", with the options
// beside the parameters that are named.
class Messages : public vtkCommand
{
public:
  static Messages* New() { return new Messages; }

  void watch(vtkAlgorithm* algorithm);
  void Execute(vtkObject* caller, unsigned long event, void* data) override;

  const std::vector<std::string>& errors() const { return errors_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

private:
  std::vector<std::string> errors_;
  std::vector<std::string> warnings_;
};
} // namespace commandline
