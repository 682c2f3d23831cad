// Progress of the filters on a terminal: one line that is written over. Interrupts are minded here too,
// since filters ask then whether they are to stop.
#pragma once

#include <vtkCommand.h>

#include <string>

class vtkAlgorithm;

namespace commandline
{
class Progress : public vtkCommand
{
public:
  static Progress* New() { return new Progress; }
  ~Progress() override { clear(); }

  // Shown only where standard error is a terminal, and never when quiet.
  void setQuiet(bool quiet);
  void watch(vtkAlgorithm* algorithm, const std::string& stage);
  void clear();
  // From now on SIGINT and SIGTERM stop the filter that runs, so that it cleans up; a second one ends the
  // program at once.
  static void catchInterrupts();
  void Execute(vtkObject* caller, unsigned long event, void* data) override;

private:
  bool shown_ = false;
  bool lineIsOpen_ = false;
  int lastPercent_ = -1;
  std::string stage_;
};
} // namespace commandline
