// A surface while it is read: points, polygons, and the named patch of each polygon.
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <map>
#include <string>
#include <vector>

class vtkCellArray;
class vtkIntArray;
class vtkPoints;
class vtkPolyData;

namespace surfaces
{
class PatchedSurface
{
public:
  PatchedSurface();
  ~PatchedSurface();

  vtkIdType addPoint(double x, double y, double z);
  vtkIdType pointCount() const;
  // Polygons added from now on belong to the patch of this name, a new one or one met before.
  void startPatch(const std::string& name);
  void addPolygon(const std::vector<vtkIdType>& points);
  // The polygons of a data set that may have a cell array of patch numbers (PatchId, or several that gmsh,
  // SimVascular, Medit or others left) and the field data PatchNames and PatchTypes; without the
  // array it is one patch, `name`, without the names they are `name`_<number>.
  void append(vtkPolyData* data, const std::string& name);
  // Gives the only patch this name; does nothing to several.
  void nameOnlyPatch(const std::string& name);

  // The polygons with their cell array PatchId (from 1), the names in field data PatchNames, whose
  // row 0 stands for the fluid, and PatchTypes where the data told them.
  vtkSmartPointer<vtkPolyData> finish() const;

private:
  struct Patch
  {
    std::string name;
    std::string type;
  };
  int patchOf(const std::string& name, const std::string& type);

  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> polygons_;
  vtkNew<vtkIntArray> patchIds_;
  std::vector<Patch> patches_;
  std::map<std::string, int> numbers_;
  int current_ = 0;
};
} // namespace surfaces
