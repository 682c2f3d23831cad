#include "NoseCone.h"

#include "Profile.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace nosecone
{
namespace
{
constexpr int bodyPatch = 1;
constexpr int basePatch = 2;

// A row of points around the axis; a pole has one.
struct Ring
{
  vtkIdType first = 0;
  int count = 1;

  vtkIdType at(int i) const { return first + i % count; }
};

class Builder
{
public:
  explicit Builder(const Shape& shape)
    : shape_(shape)
  {
    points_->SetDataTypeToDouble();
    patchIds_->SetName("PatchId");
  }

  Ring addRing(const ProfilePoint& p, int row)
  {
    const double around = 2 * std::numbers::pi * p.r / shape_.edgeLength;
    Ring ring{ points_->GetNumberOfPoints(),
      p.r > 0 ? std::max(6, static_cast<int>(std::lround(around))) : 1 };
    const double shift = row % 2 == 0 ? 0.0 : 0.5; // every other row stands in the gaps of the last one
    for (int i = 0; i < ring.count; ++i)
    {
      const double angle = 2 * std::numbers::pi * (i + shift) / ring.count;
      points_->InsertNextPoint(p.x, p.r * std::cos(angle), p.r * std::sin(angle));
    }
    return ring;
  }

  // Triangles between two rows, always along the shorter diagonal.
  void join(const Ring& a, const Ring& b, int patch)
  {
    const int startB = nearest(b, a.at(0));
    const int stepsA = a.count > 1 ? a.count : 0;
    const int stepsB = b.count > 1 ? b.count : 0;
    int i = 0;
    int j = 0;
    while (i < stepsA || j < stepsB)
    {
      const vtkIdType pa = a.at(i);
      const vtkIdType pb = b.at(startB + j);
      const bool alongA =
        j == stepsB || (i < stepsA && distance(a.at(i + 1), pb) <= distance(pa, b.at(startB + j + 1)));
      addTriangle(pa, alongA ? a.at(i + 1) : b.at(startB + j + 1), pb, patch);
      alongA ? ++i : ++j;
    }
  }

  vtkSmartPointer<vtkPolyData> finish();

private:
  double distance(vtkIdType a, vtkIdType b) const
  {
    std::array<double, 3> p{};
    std::array<double, 3> q{};
    points_->GetPoint(a, p.data());
    points_->GetPoint(b, q.data());
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  int nearest(const Ring& ring, vtkIdType point) const
  {
    int best = 0;
    for (int i = 1; i < ring.count; ++i)
    {
      if (distance(ring.at(i), point) < distance(ring.at(best), point))
      {
        best = i;
      }
    }
    return best;
  }

  // Its corners turn so that its normal points outward.
  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c, int patch)
  {
    triangles_->InsertNextCell({ a, b, c });
    patchIds_->InsertNextValue(patch);
  }

  Shape shape_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> triangles_;
  vtkNew<vtkIntArray> patchIds_;
};

void addTexts(vtkPolyData* surface, const char* name, std::array<const char*, 3> texts)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const char* text : texts)
  {
    array->InsertNextValue(text);
  }
  surface->GetFieldData()->AddArray(array);
}

// Turns the body's nose up, against a flow along the x axis.
void turn(vtkPoints* points, double degrees)
{
  const double angle = degrees * std::numbers::pi / 180;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p{};
    points->GetPoint(i, p.data());
    points->SetPoint(i, p[0] * std::cos(angle) + p[2] * std::sin(angle), p[1],
      -p[0] * std::sin(angle) + p[2] * std::cos(angle));
  }
}

vtkSmartPointer<vtkPolyData> Builder::finish()
{
  turn(points_, shape_.incidence);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points_);
  surface->SetPolys(triangles_);
  surface->GetCellData()->AddArray(patchIds_);
  addTexts(surface, "PatchNames", { "fluid", "body", "base" });
  addTexts(surface, "PatchTypes", { "fluid", "wall", "wall" });
  return surface;
}
} // namespace

vtkSmartPointer<vtkPolyData> makeSurface(const Shape& shape)
{
  const std::vector<ProfilePoint> profile = sampleProfile(shape);
  Builder builder(shape);
  Ring last = builder.addRing(profile[0], 0);
  for (std::size_t row = 1; row < profile.size(); ++row)
  {
    const Ring ring = builder.addRing(profile[row], static_cast<int>(row));
    builder.join(last, ring, profile[row].onBase ? basePatch : bodyPatch);
    last = ring;
  }
  return builder.finish();
}
} // namespace nosecone
