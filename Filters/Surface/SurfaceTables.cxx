#include "SurfaceTables.h"

#include "TableColumns.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace ransmesh
{
namespace
{
// The columns X, Y, Z.
class Places
{
public:
  explicit Places(vtkTable* table)
    : x_(addColumn<vtkDoubleArray>("X", table))
    , y_(addColumn<vtkDoubleArray>("Y", table))
    , z_(addColumn<vtkDoubleArray>("Z", table))
  {
  }

  void add(const Vector3& p)
  {
    x_->InsertNextValue(p.x);
    y_->InsertNextValue(p.y);
    z_->InsertNextValue(p.z);
  }

private:
  vtkDoubleArray* x_;
  vtkDoubleArray* y_;
  vtkDoubleArray* z_;
};

std::string namesOf(const std::vector<int>& numbers, const PatchTable& patches)
{
  std::string text;
  for (const int patch : numbers)
  {
    text += (text.empty() ? "" : ", ") + patches[patch].name;
  }
  return text;
}
} // namespace

void writeFaults(const std::vector<FaultRow>& rows, vtkTable* table)
{
  table->Initialize();
  auto* kind = addColumn<vtkStringArray>("Kind", table);
  auto* count = addColumn<vtkIdTypeArray>("Count", table);
  auto* triangles = addColumn<vtkIdTypeArray>("Triangles", table);
  auto* patches = addColumn<vtkStringArray>("Patches", table);
  Places places(table);
  for (const FaultRow& row : rows)
  {
    kind->InsertNextValue(row.kind);
    count->InsertNextValue(static_cast<vtkIdType>(row.count));
    triangles->InsertNextValue(static_cast<vtkIdType>(row.triangles));
    patches->InsertNextValue(row.patches);
    places.add(row.where);
  }
}

void writePieces(const std::vector<SurfacePiece>& pieces, const PatchTable& patches, vtkTable* table)
{
  table->Initialize();
  auto* number = addColumn<vtkIntArray>("Piece", table);
  auto* triangles = addColumn<vtkIdTypeArray>("Triangles", table);
  auto* openEdges = addColumn<vtkIdTypeArray>("OpenEdges", table);
  auto* area = addColumn<vtkDoubleArray>("Area", table);
  auto* volume = addColumn<vtkDoubleArray>("Volume", table);
  auto* enclosedBy = addColumn<vtkIntArray>("EnclosedBy", table);
  auto* names = addColumn<vtkStringArray>("Patches", table);
  vtkDoubleArray* ends[6];
  const char* endNames[6] = { "XMin", "XMax", "YMin", "YMax", "ZMin", "ZMax" };
  for (int i = 0; i < 6; ++i)
  {
    ends[i] = addColumn<vtkDoubleArray>(endNames[i], table);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const SurfacePiece& piece = pieces[i];
    number->InsertNextValue(static_cast<int>(i));
    triangles->InsertNextValue(static_cast<vtkIdType>(piece.triangles));
    openEdges->InsertNextValue(static_cast<vtkIdType>(piece.openEdges));
    area->InsertNextValue(piece.area);
    volume->InsertNextValue(piece.volume);
    enclosedBy->InsertNextValue(piece.enclosedBy);
    names->InsertNextValue(namesOf(piece.patch, patches));
    for (int k = 0; k < 3; ++k)
    {
      ends[2 * k]->InsertNextValue(piece.extent.low[k]);
      ends[2 * k + 1]->InsertNextValue(piece.extent.high[k]);
    }
  }
}

void writeRepairs(const std::vector<Repair>& repairs, vtkTable* table)
{
  table->Initialize();
  auto* text = addColumn<vtkStringArray>("Repair", table);
  auto* count = addColumn<vtkIdTypeArray>("Count", table);
  Places places(table);
  for (const Repair& repair : repairs)
  {
    text->InsertNextValue(repair.text);
    count->InsertNextValue(static_cast<vtkIdType>(repair.count));
    places.add(repair.where);
  }
}
} // namespace ransmesh
