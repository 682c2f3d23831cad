// What passes between the filter and the program that runs TetGen: two binary files on one machine.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

namespace ransmesh::worker
{
inline constexpr std::uint64_t Version = 0x52414e534d533034; // "RANSMS04"

// Exit status of the worker: 0, one of these, or, when TetGen gave up with an error number, ExitTetGen +
// number. Sanitizers end programs with statuses around 23, shells use 126 and more.
inline constexpr int ExitUsage = 2;
inline constexpr int ExitUnreadable = 3;
inline constexpr int ExitMemory = 4;
inline constexpr int ExitEndless = 5; // refinement went far beyond the points that the sizes ask for
inline constexpr int ExitTetGen = 40;
inline constexpr int ExitStalled = 6; // recovering the surface took longer than it ever does
// A line of the worker's output that starts so tells how many points the mesh has by now.
inline constexpr const char* ProgressMark = "ransmesh points ";

struct Request
{
  std::string switches;
  std::vector<double> points;                // x, y, z
  std::vector<std::int32_t> offsets;         // of polygon i: corners[offsets[i]] ... corners[offsets[i + 1]]
  std::vector<std::int32_t> corners;         // numbers of points
  std::vector<std::int32_t> markers;         // of each polygon
  std::vector<std::int32_t> segments;        // a polygon and two points: edges that lie in a polygon
  std::vector<std::int32_t> facetHoleOwners; // the polygon of each hole in a polygon
  std::vector<double> facetHoles;            // x, y, z
  std::vector<double> holes;                 // x, y, z
  std::vector<std::int32_t> freeMarkers;     // polygons with these markers may be split, in spite of -Y
  std::vector<std::int32_t> freeSides;       // pairs of points: polygon sides that may be split, too
  // The wanted edge length at x is the smallest of maximumSize (0: none) and, over all sources,
  // size + slope * distance to the source. No sources of any kind: no size is asked.
  double maximumSize = 0;
  double slope = 0;
  std::vector<double> pointSources;  // x, y, z, size
  std::vector<double> boxSources;    // xmin, xmax, ymin, ymax, zmin, zmax, size
  std::vector<double> sphereSources; // x, y, z, radius, size
  std::vector<double> lineSources;   // two ends, radius, size
};

struct Result
{
  std::vector<double> points;
  std::vector<std::int32_t> tetrahedra;  // four points each, in TetGen's order
  std::vector<std::int32_t> regions;     // of each tetrahedron, with the switch A; else empty
  std::vector<std::int32_t> faces;       // three points each: the faces on polygons
  std::vector<std::int32_t> faceMarkers; // of each face
};

// One pass over the fields serves reading and writing.
template <class Archive>
void transfer(Archive& archive, Request& r)
{
  archive(r.switches);
  archive(r.points);
  archive(r.offsets);
  archive(r.corners);
  archive(r.markers);
  archive(r.segments);
  archive(r.facetHoleOwners);
  archive(r.facetHoles);
  archive(r.holes);
  archive(r.freeMarkers);
  archive(r.freeSides);
  archive(r.maximumSize);
  archive(r.slope);
  archive(r.pointSources);
  archive(r.boxSources);
  archive(r.sphereSources);
  archive(r.lineSources);
}

template <class Archive>
void transfer(Archive& archive, Result& r)
{
  archive(r.points);
  archive(r.tetrahedra);
  archive(r.regions);
  archive(r.faces);
  archive(r.faceMarkers);
}

class Writer
{
public:
  explicit Writer(std::FILE* file)
    : file_(file)
  {
  }
  template <class T>
  void operator()(T& value)
  {
    if constexpr (std::is_arithmetic_v<T>)
    {
      good = good && std::fwrite(&value, sizeof value, 1, file_) == 1;
    }
    else
    {
      std::uint64_t size = value.size();
      (*this)(size);
      good = good && std::fwrite(value.data(), sizeof value[0], size, file_) == size;
    }
  }
  bool good = true;

private:
  std::FILE* file_;
};

class Reader
{
public:
  explicit Reader(std::FILE* file)
    : file_(file)
  {
    std::fseek(file, 0, SEEK_END);
    bytes_ = static_cast<std::uint64_t>(std::ftell(file));
    std::rewind(file);
  }
  template <class T>
  void operator()(T& value)
  {
    if constexpr (std::is_arithmetic_v<T>)
    {
      good = good && std::fread(&value, sizeof value, 1, file_) == 1;
    }
    else
    {
      std::uint64_t size = 0;
      (*this)(size);
      good = good && size <= bytes_ / sizeof value[0]; // a damaged file must not ask for all memory
      if (good)
      {
        value.resize(size);
        good = std::fread(value.data(), sizeof value[0], size, file_) == size;
      }
    }
  }
  bool good = true;

private:
  std::FILE* file_;
  std::uint64_t bytes_ = 0;
};

template <class Message>
bool save(Message& message, const std::string& path)
{
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file)
  {
    return false;
  }
  Writer writer(file);
  std::uint64_t version = Version;
  writer(version);
  transfer(writer, message);
  writer(version); // a file that was cut short lacks the end
  return (std::fclose(file) == 0) && writer.good;
}

template <class Message>
bool load(Message& message, const std::string& path)
{
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file)
  {
    return false;
  }
  Reader reader(file);
  std::uint64_t version = 0;
  reader(version);
  reader.good = reader.good && version == Version;
  transfer(reader, message);
  version = 0;
  reader(version);
  std::fclose(file);
  return reader.good && version == Version;
}
} // namespace ransmesh::worker
