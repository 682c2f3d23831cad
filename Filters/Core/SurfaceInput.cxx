#include "SurfaceInput.h"

#include "PatchFieldData.h"
#include "PatchNaming.h"
#include "PatchNumbering.h"
#include "SurfacePieces.h"

#include "Support/DataContract.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace ransmesh
{
namespace
{
class PieceReader
{
public:
  explicit PieceReader(SurfaceInput& result)
    : result_(result)
    , numbering_(result.patches)
  {
  }

  // What follows: closed surfaces or sheets.
  void begin(bool sheets, std::size_t pieces)
  {
    sheets_ = sheets;
    target_ = sheets ? &result_.sheets : &result_.surface;
    pieces_ = pieces;
    piece_ = 0;
  }

  void read(const SurfacePiece& piece)
  {
    ++piece_;
    appendTriangles(piece.data);
    if (auto numbers = numbersIn(piece.data, contract::PatchId))
    {
      assign(*numbers, piece, true);
    }
    else if (auto foreign = foreignNumbersIn(piece.data))
    {
      assign(*foreign, piece, false);
    }
    else
    {
      assignWhole(piece);
    }
  }

  void finish() { numbering_.nameGaps(); }

private:
  void appendTriangles(vtkPolyData* data)
  {
    const auto offset = static_cast<Index>(target_->points.size());
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      double x[3];
      data->GetPoint(i, x);
      target_->points.push_back({ x[0], x[1], x[2] });
    }
    vtkCellArray* polygons = data->GetPolys();
    for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* v = nullptr;
      polygons->GetCellAtId(i, size, v);
      const auto corner = [v, offset](int k) { return static_cast<Index>(v[k]) + offset; };
      target_->triangles.push_back({ corner(0), corner(1), corner(2) });
    }
  }

  std::string baseName(const SurfacePiece& piece) const
  {
    const std::string base = sheets_ ? "wake" : "surface";
    const std::string ofOne = sheets_ ? base : "";
    return !piece.name.empty() ? piece.name : pieces_ > 1 ? base + "_" + std::to_string(piece_) : ofOne;
  }

  // A sheet is a wake unless its name says something else that a sheet can be.
  PatchType typeOf(const std::string& name) const
  {
    const PatchType type = guessType(name);
    return sheets_ && type != PatchType::Wall && type != PatchType::Interface ? PatchType::Wake : type;
  }

  void assign(const std::vector<int>& numbers, const SurfacePiece& piece, bool keepNumbers)
  {
    const PatchTable named = keepNumbers ? readPatches(piece.data->GetFieldData()) : PatchTable{};
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    const std::string base = baseName(piece);
    std::map<int, int> patchOf;
    for (const int number : numbers)
    {
      patchOf[number] = 0;
    }
    for (auto& [number, patch] : patchOf)
    {
      if (number >= 1 && number < static_cast<int>(named.size()))
      {
        const Patch& given = named[number];
        const PatchType type = given.type == PatchType::Patch ? typeOf(given.name) : given.type;
        patch = numbering_.patchNamed(given.name, type, number);
        continue;
      }
      const std::string name = base.empty() ? "patch_" + std::to_string(number)
        : *least == *most                   ? base
                                            : base + "_" + std::to_string(number);
      patch = numbering_.patchNamed(name, typeOf(name), keepNumbers ? number : 0);
    }
    for (const int number : numbers)
    {
      target_->patch.push_back(patchOf[number]);
    }
  }

  void assignWhole(const SurfacePiece& piece)
  {
    const std::string base = baseName(piece);
    const std::string name = base.empty() ? "surface" : base;
    const int patch = numbering_.patchNamed(name, typeOf(name), 0);
    target_->patch.resize(target_->triangles.size(), patch);
    auto& whole = result_.wholePieces;
    if (!sheets_ && std::find(whole.begin(), whole.end(), patch) == whole.end())
    {
      whole.push_back(patch);
    }
  }

  SurfaceInput& result_;
  PatchNumbering numbering_;
  SurfaceMesh* target_ = nullptr;
  bool sheets_ = false;
  std::size_t pieces_ = 0;
  std::size_t piece_ = 0;
};

Outcome readPieces(const std::vector<vtkDataObject*>& inputs, bool sheets, PieceReader& reader)
{
  std::vector<SurfacePiece> pieces;
  if (Outcome outcome = collectPieces(inputs, pieces); !outcome.ok())
  {
    return outcome;
  }
  vtkIdType points = 0;
  for (const SurfacePiece& piece : pieces)
  {
    points += piece.data->GetNumberOfPoints() + 2 * piece.data->GetNumberOfPolys();
  }
  if (points > std::numeric_limits<Index>::max() / 8)
  {
    return Outcome::badInput("the surface is too large: more than 250 million points and triangles");
  }
  reader.begin(sheets, pieces.size());
  for (const SurfacePiece& piece : pieces)
  {
    reader.read(piece);
  }
  return Outcome::done();
}

// Marks the patches of sheets, which must not be those of surfaces.
Outcome tellSheets(SurfaceInput& result)
{
  result.isSheet.assign(result.patches.size(), 0);
  for (const int patch : result.sheets.patch)
  {
    result.isSheet[patch] = 1;
  }
  for (const int patch : result.surface.patch)
  {
    if (result.isSheet[patch])
    {
      return Outcome::badInput("the patch '" + result.patches[patch].name +
        "' is there in the surfaces and in the sheets: give the sheet a name of its own");
    }
  }
  return Outcome::done();
}
} // namespace

Outcome readSurface(const std::vector<vtkDataObject*>& surfaces, const std::vector<vtkDataObject*>& sheets,
  SurfaceInput& result)
{
  PieceReader reader(result);
  if (Outcome outcome = readPieces(surfaces, false, reader); !outcome.ok())
  {
    return outcome;
  }
  if (Outcome outcome = readPieces(sheets, true, reader); !outcome.ok())
  {
    return outcome;
  }
  reader.finish();
  return tellSheets(result);
}
} // namespace ransmesh
