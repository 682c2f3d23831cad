// Whether a data set's arrays are as long as they must be.
#ifndef ArrayLengths_h
#define ArrayLengths_h

#include "Support/Outcome.h"

class vtkDataSet;

namespace ransmesh
{
// BadInput names the first array of points or cells that has fewer values than there are points or cells. Scripts
// make such; VTK reads beyond their ends without a word.
Outcome checkArrayLengths(vtkDataSet* data);
} // namespace ransmesh

#endif
