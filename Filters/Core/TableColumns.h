// Columns of tables.
#ifndef TableColumns_h
#define TableColumns_h

#include "vtkNew.h"
#include "vtkTable.h"

namespace ransmesh
{
// The new column, which the table owns.
template <class Array>
Array* addColumn(const char* name, vtkTable* table)
{
  vtkNew<Array> column;
  column->SetName(name);
  table->AddColumn(column);
  return column;
}
} // namespace ransmesh

#endif
