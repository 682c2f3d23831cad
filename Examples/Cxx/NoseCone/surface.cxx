// nosecone-surface FILE.vtp [EDGE_LENGTH [SHOULDER_RADIUS]]: the examples' body as a file.
#include "NoseCone.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int count, char* words[])
{
  if (count < 2 || count > 4)
  {
    std::fprintf(stderr, "usage: nosecone-surface FILE.vtp [EDGE_LENGTH [SHOULDER_RADIUS]]\n");
    return 2;
  }
  try
  {
    nosecone::Shape shape;
    shape.edgeLength = count > 2 ? std::atof(words[2]) : shape.edgeLength;
    shape.shoulderRadius = count > 3 ? std::atof(words[3]) : shape.shoulderRadius;
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(nosecone::makeSurface(shape));
    writer->SetFileName(words[1]);
    writer->SetDataModeToBinary(); // some ParaViews cannot read the default, appended
    return writer->Write() == 1 ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "nosecone-surface: %s\n", error.what());
    return 1;
  }
}
