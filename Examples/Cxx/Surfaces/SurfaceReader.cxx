#include "SurfaceReader.h"

#include "FileContent.h"
#include "ObjReader.h"
#include "PatchedSurface.h"
#include "StlReader.h"

#include <vtkFieldData.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <set>
#include <stdexcept>

namespace surfaces
{
namespace
{
template <typename Reader>
void readByVtk(const std::string& content, const std::string& stem, PatchedSurface& surface)
{
  vtkNew<Reader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(content);
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    throw std::runtime_error("VTK's reader could not read it");
  }
  vtkNew<vtkTriangleFilter> triangles; // triangle strips become polygons
  triangles->SetInputData(reader->GetOutput());
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  triangles->GetOutput()->GetFieldData()->ShallowCopy(reader->GetOutput()->GetFieldData());
  surface.append(triangles->GetOutput(), stem);
}

vtkSmartPointer<vtkPolyData> readOne(const std::string& path)
{
  const std::string extension = extensionOf(path);
  const std::string content = readFile(path);
  PatchedSurface surface;
  if (extension == ".stl")
  {
    readStl(content, surface);
    surface.nameOnlyPatch(stemOf(path));
  }
  else if (extension == ".obj")
  {
    readObj(content, surface);
    surface.nameOnlyPatch(stemOf(path));
  }
  else if (extension == ".ply")
  {
    readByVtk<vtkPLYReader>(content, stemOf(path), surface);
  }
  else
  {
    readByVtk<vtkXMLPolyDataReader>(content, stemOf(path), surface);
  }
  vtkSmartPointer<vtkPolyData> data = surface.finish();
  if (data->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error("has no triangles or polygons, or is damaged");
  }
  return data;
}

vtkStringArray* namesOf(vtkPolyData* data)
{
  return vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("PatchNames"));
}

// Puts the file's stem before the names that another file had already.
void separateNames(vtkPolyData* data, const std::string& stem, std::set<std::string>& taken)
{
  vtkStringArray* names = namesOf(data);
  for (vtkIdType i = 1; i < names->GetNumberOfValues(); ++i)
  {
    std::string name = names->GetValue(i);
    for (int copy = 1; !taken.insert(name).second; ++copy)
    {
      name = stem + "_" + names->GetValue(i) + (copy > 1 ? "_" + std::to_string(copy) : "");
    }
    names->SetValue(i, name);
  }
}
} // namespace

bool isSurfaceFile(const std::string& path)
{
  const std::string extension = extensionOf(path);
  return extension == ".stl" || extension == ".obj" || extension == ".ply" || extension == ".vtp";
}

vtkSmartPointer<vtkPolyData> readSurfaces(const std::vector<std::string>& paths)
{
  PatchedSurface all;
  std::set<std::string> taken;
  for (const std::string& path : paths)
  {
    try
    {
      const vtkSmartPointer<vtkPolyData> one = readOne(path);
      separateNames(one, stemOf(path), taken);
      all.append(one, stemOf(path));
    }
    catch (const std::runtime_error& error)
    {
      const std::string what = error.what();
      throw std::runtime_error(what.rfind(path, 0) == 0 ? what : path + ": " + what);
    }
  }
  return all.finish();
}
} // namespace surfaces
