// The cases that the layers are judged by, one at a time:
//   ransmesh-cases list
//   ransmesh-cases CASE|SURFACE [--size S] [--h0 H] [--layers N] [--growth G] [--thickness T] [--far-field]
//                  [--swap-angle A] [--walls PATTERN...] [-o MESH.vtu] [--surface FILE.vtp] [--json FILE]
// SURFACE is a file that ransmesh reads. Status 0: the mesh is valid; 1: it is not, or there is none; 2: wrong use.
#include "Bodies/Cases.h"
#include "Vtk/BodyPolyData.h"
#include "Vtk/ChainRun.h"

#ifdef RANSMESHING_READS_SURFACES
#include "SurfaceReader.h"
#endif

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace
{
using namespace chain_run;

struct Arguments
{
  std::string subject;
  double size = 0;
  double thickness = 0;
  std::optional<double> firstHeight;
  ChainOptions options;
  std::string mesh;
  std::string surface;
  std::string json;
};

struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

Arguments parse(int argc, char** argv)
{
  Arguments a;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const auto next = [&]
    {
      if (i + 1 == argc)
      {
        throw UsageError(word + " needs a value");
      }
      return std::string(argv[++i]);
    };
    if (word == "--size")
    {
      a.size = std::stod(next());
    }
    else if (word == "--h0")
    {
      a.firstHeight = std::stod(next());
    }
    else if (word == "--layers")
    {
      a.options.layers = std::stoi(next());
    }
    else if (word == "--growth")
    {
      a.options.growth = std::stod(next());
    }
    else if (word == "--swap-angle")
    {
      a.options.swapAngle = std::stod(next());
    }
    else if (word == "--thickness")
    {
      a.thickness = std::stod(next());
    }
    else if (word == "--far-field")
    {
      a.options.farField = true;
    }
    else if (word == "--walls")
    {
      while (i + 1 < argc && argv[i + 1][0] != '-')
      {
        a.options.walls.push_back(next());
      }
    }
    else if (word == "-o")
    {
      a.mesh = next();
    }
    else if (word == "--surface")
    {
      a.surface = next();
    }
    else if (word == "--json")
    {
      a.json = next();
    }
    else if (word[0] == '-')
    {
      throw UsageError(word + " is no option");
    }
    else
    {
      a.subject = word;
    }
  }
  if (a.subject.empty())
  {
    throw UsageError("a case is missing");
  }
  return a;
}

int list()
{
  for (const bodies::Case& c : bodies::allCases())
  {
    std::printf("%-24s size %g, for tests %g; goals: inserted %g, full %g, > 175 %g, > 179 %g\n",
      c.name.c_str(), c.size, c.testSize, c.goals.inserted, c.goals.fullColumns, c.goals.over175,
      c.goals.over179);
  }
  return 0;
}

// The body of a case, whose layers go into the options.
bodies::Body makeBody(const bodies::Case& c, Arguments& a)
{
  const double size = a.size > 0 ? a.size : c.size;
  bodies::Layers layers = c.layers(size);
  layers.firstHeight = a.firstHeight.value_or(layers.firstHeight);
  layers.growth = a.options.growth;
  layers.number = a.options.layers;
  if (a.thickness > 0)
  {
    layers.firstHeight *= a.thickness / layers.thickness();
  }
  bodies::Body body = c.make(size, layers);
  const ChainOptions options = optionsFor(c, layers, body);
  a.options.firstHeight = options.firstHeight;
  a.options.patchLayers = options.patchLayers;
  if (a.options.walls.empty())
  {
    a.options.walls = options.walls;
  }
  return body;
}

vtkSmartPointer<vtkPolyData> readSurface(Arguments& a)
{
#ifdef RANSMESHING_READS_SURFACES
  a.options.firstHeight = a.firstHeight.value_or(a.options.firstHeight);
  a.options.surfaceSize = a.size;
  return surfaces::readSurfaces({ a.subject });
#else
  throw UsageError("there is no case " + a.subject);
#endif
}

template <class Writer, class Data>
void write(Data* data, const std::string& path)
{
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetFileName(path.c_str());
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToNone();
  if (!writer->Write())
  {
    throw std::runtime_error("cannot write " + path);
  }
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' || c == '\\' ? std::string("\\") + c : c == '\n' ? " " : std::string(1, c);
  }
  return result + "\"";
}

void writeNumbers(const std::vector<int>& numbers, std::ostream& text)
{
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    text << (i > 0 ? ", " : "") << numbers[i];
  }
}

std::string toJson(const Arguments& a, const ChainResult& r)
{
  std::ostringstream text;
  text.precision(9);
  text << "{\"case\": " << quoted(a.subject) << ", \"first_height\": " << a.options.firstHeight
       << ", \"growth\": " << a.options.growth << ", \"layers\": " << a.options.layers
       << ",\n \"valid\": " << (r.faults.empty() ? "true" : "false") << ", \"faults\": " << quoted(r.faults)
       << ",\n \"seconds\": [" << r.seconds[0] << ", " << r.seconds[1] << ", " << r.seconds[2] << "]"
       << ",\n \"marked\": " << r.marked << ", \"removed\": " << r.removed << ", \"of_shape\": " << r.ofShape
       << ", \"asked\": " << r.asked << ", \"requested\": " << r.requested << ", \"inserted\": " << r.inserted
       << ",\n \"columns\": " << r.columns << ", \"full_columns\": " << r.fullColumns
       << ",\n \"stop_reasons\": {";
  const char* separator = "";
  for (const auto& [reason, count] : r.stopReasons)
  {
    text << separator << quoted(reason) << ": " << count;
    separator = ", ";
  }
  text << "},\n \"walls_of_their_own\": " << a.options.patchLayers.size() << ", \"walls\": [";
  writeNumbers(r.walls, text);
  text << "], \"sheets\": [";
  writeNumbers(r.sheets, text);
  text << "],\n \"tetrahedra\": " << r.tetrahedra << ", \"layer_tetrahedra\": " << r.layerTetrahedra
       << ", \"over_175\": " << r.over175 << ", \"over_179\": " << r.over179
       << ", \"largest_angle\": " << r.largestAngle
       << ", \"largest_angle_outside\": " << r.largestAngleOutside << ", \"volume_change\": ["
       << r.volumeChangeByRemoval << ", " << r.volumeChange << "]"
       << ", \"area_with_first_height\": " << r.areaWithFirstHeight
       << ", \"area_away_from_gaps\": " << r.areaAwayFromGaps
       << ", \"columns_with_their_layers\": " << r.columnsWithTheirLayers
       << ", \"growth_off\": " << r.growthOff << ", \"copies_of_wall_faces\": " << r.copiesOfWallFaces
       << "}\n";
  return text.str();
}

int run(Arguments a)
{
  const bodies::Case* c = bodies::findCase(a.subject);
  const bodies::Body body = c ? makeBody(*c, a) : bodies::Body{};
  const vtkSmartPointer<vtkPolyData> surface = c ? toPolyData(body) : readSurface(a);
  if (!a.surface.empty())
  {
    write<vtkXMLPolyDataWriter>(surface.Get(), a.surface);
  }
  const ChainResult result = c ? runChain(body, a.options) : runChain(surface, a.options);
  const std::string json = toJson(a, result);
  std::cout << json;
  if (!a.json.empty())
  {
    std::ofstream(a.json) << json;
  }
  if (!a.mesh.empty())
  {
    write<vtkXMLUnstructuredGridWriter>(result.mesh.Get(), a.mesh);
  }
  return result.faults.empty() ? 0 : 1;
}
} // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc == 2 && std::string(argv[1]) == "list")
    {
      return list();
    }
    return run(parse(argc, argv));
  }
  catch (const UsageError& error)
  {
    std::cerr << "ransmesh-cases: " << error.what() << "\n";
    return 2;
  }
  catch (const std::exception& error)
  {
    std::cerr << "ransmesh-cases: " << error.what() << "\n";
    return 1;
  }
}
