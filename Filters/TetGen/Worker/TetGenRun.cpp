#include "TetGenRun.h"

#include "SizeField.h"
#include "SizeLimits.h"
#include "StallGuard.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <memory>

#ifndef TETLIBRARY
#define TETLIBRARY
#endif
// The header's inline version frees the mesh and then throws; the library's calls shall reach the
// function below instead.
#define terminatetetgen terminatetetgenOfTheHeader
#include <tetgen.h>
#undef terminatetetgen

__attribute__((visibility("default"))) void terminatetetgen(tetgenmesh*, int code)
{
  std::fflush(stdout);
  std::_Exit(ransmesh::worker::ExitTetGen + code);
}

namespace ransmesh::worker
{
namespace
{
// A tetrahedron is too large when its circumradius exceeds this times the wanted edge length. An
// equilateral one has 0.61; with 0.8 the mean edge of a mesh is 0.97 of what was wanted (measured).
constexpr double LargestCircumradius = 0.8;
// A tetrahedron with an edge shorter than this times the wanted length is left to the quality measures:
// at needles of the surface circumradii are large whatever is inserted.
constexpr double ShortestEdge = 0.4;

// How many points edges of length h take in a body, with sizes growing by `slope` around it.
double pointsIn(double volume, double area, double h, double slope)
{
  return volume / (0.7 * h * h * h) + area / (h * h * slope);
}

// Far above what a sound mesh needs.
double mostPoints(const Request& request)
{
  Vector3 low{ request.points[0], request.points[1], request.points[2] };
  Vector3 high = low;
  for (std::size_t i = 0; i < request.points.size(); ++i)
  {
    low[i % 3] = std::min(low[i % 3], request.points[i]);
    high[i % 3] = std::max(high[i % 3], request.points[i]);
  }
  const double onSurface = static_cast<double>(request.points.size()) / 3;
  double asked = onSurface * (1 + 1 / request.slope);
  if (request.maximumSize > 0)
  {
    const Vector3 d = high - low;
    asked += pointsIn(d.x * d.y * d.z, 0, request.maximumSize, request.slope);
  }
  const auto& b = request.boxSources;
  for (std::size_t i = 0; i + 6 < b.size(); i += 7)
  {
    const Vector3 d{ b[i + 1] - b[i], b[i + 3] - b[i + 2], b[i + 5] - b[i + 4] };
    asked += pointsIn(d.x * d.y * d.z, 2 * (d.x * d.y + d.y * d.z + d.z * d.x), b[i + 6], request.slope);
  }
  const auto& s = request.sphereSources;
  for (std::size_t i = 0; i + 4 < s.size(); i += 5)
  {
    const double r = s[i + 3];
    asked += pointsIn(4.2 * r * r * r, 12.6 * r * r, s[i + 4], request.slope);
  }
  const auto& l = request.lineSources;
  for (std::size_t i = 0; i + 7 < l.size(); i += 8)
  {
    const double r = l[i + 6];
    const double length = distance({ l[i], l[i + 1], l[i + 2] }, { l[i + 3], l[i + 4], l[i + 5] });
    asked +=
      pointsIn((3.2 * length + 4.2 * r) * r * r, (6.3 * length + 12.6 * r) * r, l[i + 7], request.slope);
    asked += length / l[i + 7]; // a line without a radius
  }
  return 2e4 + 5 * asked;
}

// The wanted size at mesh points. TetGen asks about tetrahedra by the addresses of their points, so
// the size of each point is computed once and found again by address.
class PointCache
{
public:
  explicit PointCache(const Request& request)
    : points_(pointsOf(request), request.slope)
    , mostPoints_(mostPoints(request))
    , givenPoints_(static_cast<double>(request.points.size()) / 3)
  {
    limits_.maximum = request.maximumSize;
    limits_.slope = request.slope;
    const auto& b = request.boxSources;
    for (std::size_t i = 0; i + 6 < b.size(); i += 7)
    {
      limits_.boxes.push_back({ { b[i], b[i + 2], b[i + 4] }, { b[i + 1], b[i + 3], b[i + 5] }, b[i + 6] });
    }
    const auto& s = request.sphereSources;
    for (std::size_t i = 0; i + 4 < s.size(); i += 5)
    {
      limits_.spheres.push_back({ { s[i], s[i + 1], s[i + 2] }, s[i + 3], s[i + 4] });
    }
    const auto& l = request.lineSources;
    for (std::size_t i = 0; i + 7 < l.size(); i += 8)
    {
      limits_.lines.push_back(
        { { l[i], l[i + 1], l[i + 2] }, { l[i + 3], l[i + 4], l[i + 5] }, l[i + 6], l[i + 7] });
    }
  }

  double sizeAt(const double* p)
  {
    const auto address = reinterpret_cast<std::uintptr_t>(p);
    Entry& entry = entries_[((address >> 4) * 0x9E3779B97F4A7C15u) >> (64 - Bits)];
    if (entry.address != p || std::memcmp(entry.place.data(), p, sizeof entry.place) != 0)
    {
      const Vector3 place{ p[0], p[1], p[2] };
      entry = { p, { p[0], p[1], p[2] }, std::min(limits_.at(place), points_.at(place)) };
      count();
    }
    return entry.size;
  }

  // To be called at each question of TetGen: ends the process when refining hardly gets on, as it happens
  // among needles, where each point that is tried reaches through much of the mesh.
  void watch()
  {
    if (++questions_ == 1) // TetGen asks about sizes when the surface is recovered
    {
      endRecovery();
      began_ = processorTime();
    }
    if (questions_ % 16 != 0) // among needles one answer may take TetGen a second
    {
      return;
    }
    constexpr double patience = 10;           // seconds
    constexpr double patiencePerPoint = 2e-4; // to look at what is given
    constexpr double leastRate = 200;         // points a second; sound meshes take 20000
    const double seconds = processorTime() - began_;
    if (seconds > patience + patiencePerPoint * givenPoints_ && seen_ - givenPoints_ < leastRate * seconds)
    {
      giveUp();
    }
  }

private:
  struct Entry
  {
    const double* address = nullptr;
    std::array<double, 3> place{};
    double size = 0;
  };

  static double processorTime() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

  static std::vector<SizePoint> pointsOf(const Request& request)
  {
    std::vector<SizePoint> points;
    const auto& s = request.pointSources;
    for (std::size_t i = 0; i + 3 < s.size(); i += 4)
    {
      points.push_back({ { s[i], s[i + 1], s[i + 2] }, s[i + 3] });
    }
    return points;
  }

  void count()
  {
    if (std::fmod(++seen_, 20000) == 0)
    {
      std::printf("%s%.0f\n", ProgressMark, seen_);
    }
    if (seen_ > mostPoints_)
    {
      giveUp();
    }
  }

  [[noreturn]] void giveUp() const
  {
    std::printf("refining does not end: %.0f points\n", seen_);
    std::fflush(stdout);
    std::_Exit(ExitEndless);
  }

  static constexpr int Bits = 21;
  std::vector<Entry> entries_ = std::vector<Entry>(std::size_t(1) << Bits);
  SizeLimits limits_;
  PointSizes points_;
  double mostPoints_;
  double givenPoints_;
  double seen_ = 0;
  long questions_ = 0;
  double began_ = 0; // refining, in processor time
};

// TetGen's callback has no place for data of the caller.
std::unique_ptr<PointCache> sizes;

bool isTooLarge(double* a, double* b, double* c, double* d, double*, double)
{
  sizes->watch();
  const double wanted = (sizes->sizeAt(a) + sizes->sizeAt(b) + sizes->sizeAt(c) + sizes->sizeAt(d)) / 4;
  const Vector3 u{ a[0] - d[0], a[1] - d[1], a[2] - d[2] };
  const Vector3 v{ b[0] - d[0], b[1] - d[1], b[2] - d[2] };
  const Vector3 w{ c[0] - d[0], c[1] - d[1], c[2] - d[2] };
  const double shortest2 =
    std::min({ dot(u, u), dot(v, v), dot(w, w), dot(u - v, u - v), dot(v - w, v - w), dot(w - u, w - u) });
  if (shortest2 < ShortestEdge * ShortestEdge * wanted * wanted)
  {
    return false;
  }
  const Vector3 vw = cross(v, w);
  const double determinant = dot(u, vw);
  const Vector3 toCentre = dot(u, u) * vw + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v);
  const double limit = 2 * LargestCircumradius * wanted * determinant;
  return dot(toCentre, toCentre) > limit * limit;
}

void setPolygon(const std::int32_t* corners, int count, tetgenio::polygon& polygon)
{
  tetgenio::init(&polygon);
  polygon.numberofvertices = count;
  polygon.vertexlist = new int[count];
  std::copy_n(corners, count, polygon.vertexlist);
}

void setFacetHoles(const Request& request, tetgenio& in)
{
  std::map<std::int32_t, std::vector<double>> holesOf;
  for (std::size_t i = 0; i < request.facetHoleOwners.size(); ++i)
  {
    const double* hole = request.facetHoles.data() + 3 * i;
    auto& holes = holesOf[request.facetHoleOwners[i]];
    holes.insert(holes.end(), hole, hole + 3);
  }
  for (const auto& [polygon, holes] : holesOf)
  {
    tetgenio::facet& facet = in.facetlist[polygon];
    facet.numberofholes = static_cast<int>(holes.size() / 3);
    facet.holelist = new double[holes.size()];
    std::copy(holes.begin(), holes.end(), facet.holelist);
  }
}

void setFacets(const Request& request, tetgenio& in)
{
  std::vector<std::vector<std::size_t>> segmentsOf(request.markers.size());
  for (std::size_t i = 0; i + 2 < request.segments.size(); i += 3)
  {
    segmentsOf[request.segments[i]].push_back(i + 1);
  }
  in.numberoffacets = static_cast<int>(request.markers.size());
  in.facetlist = new tetgenio::facet[request.markers.size()];
  in.facetmarkerlist = new int[request.markers.size()];
  for (std::size_t i = 0; i < request.markers.size(); ++i)
  {
    tetgenio::facet& facet = in.facetlist[i];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1 + static_cast<int>(segmentsOf[i].size());
    facet.polygonlist = new tetgenio::polygon[facet.numberofpolygons];
    const std::int32_t begin = request.offsets[i];
    setPolygon(request.corners.data() + begin, request.offsets[i + 1] - begin, facet.polygonlist[0]);
    for (std::size_t j = 0; j < segmentsOf[i].size(); ++j)
    {
      setPolygon(request.segments.data() + segmentsOf[i][j], 2, facet.polygonlist[j + 1]);
    }
    in.facetmarkerlist[i] = request.markers[i];
  }
  setFacetHoles(request, in);
}

// With -Y nothing on polygons is split, except where a constraint is given: a bound so large that it
// never binds sets a polygon free.
void setFreedom(const Request& request, tetgenio& in)
{
  constexpr double noBound = 1e300;
  in.numberoffacetconstraints = static_cast<int>(request.freeMarkers.size());
  in.facetconstraintlist = new double[2 * request.freeMarkers.size() + 1];
  for (std::size_t i = 0; i < request.freeMarkers.size(); ++i)
  {
    in.facetconstraintlist[2 * i] = request.freeMarkers[i];
    in.facetconstraintlist[2 * i + 1] = noBound;
  }
  in.numberofsegmentconstraints = static_cast<int>(request.freeSides.size() / 2);
  in.segmentconstraintlist = new double[3 * request.freeSides.size() / 2 + 1];
  for (std::size_t i = 0; i + 1 < request.freeSides.size(); i += 2)
  {
    double* constraint = in.segmentconstraintlist + 3 * (i / 2);
    constraint[0] = request.freeSides[i];
    constraint[1] = request.freeSides[i + 1];
    constraint[2] = noBound;
  }
}

void setInput(const Request& request, tetgenio& in)
{
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(request.points.size() / 3);
  in.pointlist = new double[request.points.size()];
  std::copy(request.points.begin(), request.points.end(), in.pointlist);
  setFacets(request, in);
  if (!request.freeMarkers.empty())
  {
    setFreedom(request, in);
  }
  if (!request.holes.empty())
  {
    in.numberofholes = static_cast<int>(request.holes.size() / 3);
    in.holelist = new double[request.holes.size()];
    std::copy(request.holes.begin(), request.holes.end(), in.holelist);
  }
  if (!request.pointSources.empty() || request.maximumSize > 0)
  {
    sizes = std::make_unique<PointCache>(request);
    in.tetunsuitable = isTooLarge;
  }
}

Result resultOf(const tetgenio& out)
{
  Result result;
  const auto tets = static_cast<std::size_t>(out.numberoftetrahedra);
  result.points.assign(out.pointlist, out.pointlist + 3 * static_cast<std::size_t>(out.numberofpoints));
  result.tetrahedra.assign(out.tetrahedronlist, out.tetrahedronlist + 4 * tets);
  if (out.tetrahedronattributelist && out.numberoftetrahedronattributes > 0)
  {
    for (std::size_t i = 0; i < tets; ++i)
    {
      result.regions.push_back(
        static_cast<std::int32_t>(out.tetrahedronattributelist[i * out.numberoftetrahedronattributes]));
    }
  }
  if (out.trifacelist && out.trifacemarkerlist)
  {
    const auto faces = static_cast<std::size_t>(out.numberoftrifaces);
    result.faces.assign(out.trifacelist, out.trifacelist + 3 * faces);
    result.faceMarkers.assign(out.trifacemarkerlist, out.trifacemarkerlist + faces);
  }
  return result;
}
} // namespace

Result runTetGen(const Request& request)
{
  tetgenio in;
  tetgenio out;
  setInput(request, in);
  std::string switches = request.switches;
  watchRecovery(request.points.size() / 3);
  tetrahedralize(switches.data(), &in, &out);
  endRecovery();
  return resultOf(out);
}
} // namespace ransmesh::worker
