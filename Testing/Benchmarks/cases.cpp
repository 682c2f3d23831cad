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
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
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

// The words of the command line that have not been read yet.
class Words
{
public:
  Words(int argc, char** argv)
    : words_(argv + 1, argv + argc)
  {
  }
  bool atEnd() const { return at_ == words_.size(); }
  bool atValue() const { return !atEnd() && words_[at_][0] != '-'; }
  const std::string& next() { return words_[at_++]; }
  const std::string& valueOf(const std::string& option)
  {
    if (atEnd())
    {
      throw UsageError(option + " needs a value");
    }
    return next();
  }

private:
  std::vector<std::string> words_;
  std::size_t at_ = 0;
};

double numberOf(Words& words, const std::string& option)
{
  const std::string word = words.valueOf(option);
  char* end = nullptr;
  const double number = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != 0)
  {
    throw UsageError(option + " needs a number, not " + word);
  }
  return number;
}

void readWalls(Arguments& a, Words& words, const std::string& option)
{
  do
  {
    a.options.walls.push_back(words.valueOf(option));
  } while (words.atValue());
}

using Reader = void (*)(Arguments&, Words&, const std::string&);

const std::map<std::string, Reader>& readers()
{
  using A = Arguments;
  using S = const std::string;
  static const std::map<std::string, Reader> all = {
    { "--size", [](A& a, Words& w, S& name) { a.size = numberOf(w, name); } },
    { "--h0", [](A& a, Words& w, S& name) { a.firstHeight = numberOf(w, name); } },
    { "--layers", [](A& a, Words& w, S& name) { a.options.layers = static_cast<int>(numberOf(w, name)); } },
    { "--growth", [](A& a, Words& w, S& name) { a.options.growth = numberOf(w, name); } },
    { "--swap-angle", [](A& a, Words& w, S& name) { a.options.swapAngle = numberOf(w, name); } },
    { "--thickness", [](A& a, Words& w, S& name) { a.thickness = numberOf(w, name); } },
    { "--far-field", [](A& a, Words&, S&) { a.options.farField = true; } },
    { "--walls", readWalls },
    { "-o", [](A& a, Words& w, S& name) { a.mesh = w.valueOf(name); } },
    { "--surface", [](A& a, Words& w, S& name) { a.surface = w.valueOf(name); } },
    { "--json", [](A& a, Words& w, S& name) { a.json = w.valueOf(name); } },
  };
  return all;
}

Arguments parse(int argc, char** argv)
{
  Arguments a;
  for (Words words(argc, argv); !words.atEnd();)
  {
    const bool isSubject = words.atValue();
    const std::string& word = words.next();
    if (isSubject)
    {
      a.subject = word;
      continue;
    }
    const auto reader = readers().find(word);
    if (reader == readers().end())
    {
      throw UsageError(word + " is no option");
    }
    reader->second(a, words, word);
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
