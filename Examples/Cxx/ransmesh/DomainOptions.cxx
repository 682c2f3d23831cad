#include "Arguments.h"

#include <set>

namespace commandline
{
namespace
{
// x, y or z, or with a place: z=0.25.
PlaneOption planeOf(Arguments& arguments, const std::string& option)
{
  const std::string& word = arguments.valueOf(option);
  const std::size_t axis = word.empty() ? std::string::npos : std::string("xyz").find(word[0]);
  if (axis == std::string::npos || (word.size() > 1 && word[1] != '='))
  {
    throw UsageError(option + " needs an axis and a place, as in z=0.25, not " + word);
  }
  return { static_cast<int>(axis) + 1, word.size() > 1 ? finiteNumber(word.substr(2), option) : 0 };
}

// SIDE=NAME or SIDE=NAME:TYPE.
SideOption sideOf(const std::string& word)
{
  static const std::set<std::string> sides = { "xmin", "xmax", "ymin", "ymax", "zmin", "zmax" };
  const std::size_t equals = word.find('=');
  const std::size_t colon = word.find(':');
  const std::size_t begin = equals + 1;
  if (equals == std::string::npos || !sides.contains(word.substr(0, equals)) || begin == word.size() ||
    begin == colon)
  {
    throw UsageError("--side needs SIDE=NAME or SIDE=NAME:TYPE, as in xmin=inlet, not " + word);
  }
  return { word.substr(0, equals), word.substr(begin, colon == std::string::npos ? colon : colon - begin),
    colon == std::string::npos ? "" : word.substr(colon + 1) };
}

void addSides(Options& options, Arguments& arguments, const std::string& option)
{
  for (const std::string& word : valuesOf(arguments, option))
  {
    options.sides.push_back(sideOf(word));
  }
}

// So many numbers, the last of them a length above 0.
template <std::size_t N>
std::array<double, N> numbersOf(Arguments& arguments, const std::string& option)
{
  std::array<double, N> numbers{};
  for (double& number : numbers)
  {
    number = finiteNumber(arguments.valueOf(option), option);
  }
  if (numbers.back() <= 0)
  {
    throw UsageError(option + ": the last number is the edge length; it must be above 0");
  }
  return numbers;
}

void setFarField(Options& options, double margin, bool sphere)
{
  if (options.farField > 0)
  {
    throw UsageError("--far-field or --far-field-sphere: give one of them, once");
  }
  options.farField = margin;
  options.sphere = sphere;
}

void check(const Options& options)
{
  const bool isShaped = options.farField > 0 || options.size > 0 || options.sizeGrowth > 0 ||
    options.refine.isGiven() || options.symmetry.axis > 0 || options.waterline.axis > 0 ||
    options.ground.axis > 0 || !options.keptInsides.empty();
  if (options.isMesh() && isShaped)
  {
    throw UsageError(
      "options for the domain have no meaning: " + options.surfaces.front() + " is a mesh already");
  }
  if (!options.sides.empty() && (options.farField == 0 || options.sphere))
  {
    throw UsageError("--side names the sides of the box that --far-field makes: give that, too");
  }
}
} // namespace

const OptionGroup& domainOptions()
{
  using O = Options;
  using A = Arguments;
  using S = const std::string;
  static const OptionGroup group = {
    {
      { "--far-field", [](O& o, A& a, S& name) { setFarField(o, positiveOf(a, name), false); } },
      { "--far-field-sphere", [](O& o, A& a, S& name) { setFarField(o, positiveOf(a, name), true); } },
      { "--side", addSides },
      { "--symmetry-plane", [](O& o, A& a, S& name) { o.symmetry = planeOf(a, name); } },
      { "--waterline", [](O& o, A& a, S& name) { o.waterline = planeOf(a, name); } },
      { "--ground", [](O& o, A& a, S& name) { o.ground = planeOf(a, name); } },
      { "--keep-inside", [](O& o, A& a, S& name) { addValues(a, name, o.keptInsides); } },
      { "--size", [](O& o, A& a, S& name) { o.size = positiveOf(a, name); } },
      { "--size-growth", [](O& o, A& a, S& name) { o.sizeGrowth = positiveOf(a, name, 1); } },
      { "--refine-box", [](O& o, A& a, S& name) { o.refine.boxes.push_back(numbersOf<7>(a, name)); } },
      { "--refine-sphere", [](O& o, A& a, S& name) { o.refine.spheres.push_back(numbersOf<5>(a, name)); } },
      { "--refine-line", [](O& o, A& a, S& name) { o.refine.lines.push_back(numbersOf<8>(a, name)); } },
    },
    check, R"(
Domain
  --far-field M         a box around the bodies, M body lengths on each side;
                        without it the surfaces themselves bound the domain
  --far-field-sphere M  a sphere instead, M body lengths from the bodies
  --side SIDE=NAME[:TYPE]...
                        names sides of the box: xmin=inlet xmax=outlet zmax=top:symmetry; what is
                        not told of the type, the name suggests; sides of one name are one patch
  --symmetry-plane AXIS[=V]
                        a plane of symmetry, as in y or y=0.5: what lies on its lesser side is cut
                        off; half models may end in it, open; patch `symmetry`
  --waterline z=V       what lies above this plane is cut off; patch `waterline`, of type symmetry
  --ground z=V          what lies below this plane is cut off, as of wheels; patch `ground`, a wall
  --keep-inside PATCH...
                        meshes the inside of these bodies, too (names, wildcards): a region of its own,
                        the body's surface between them; all patches of a body together
  --size L              largest edge in the field
  --size-growth G       ratio of successive edges away from surfaces and places of refinement (1.3)
  --refine-box XMIN XMAX YMIN YMAX ZMIN ZMAX L
  --refine-sphere X Y Z RADIUS L
  --refine-line X1 Y1 Z1 X2 Y2 Z2 RADIUS L
                        edges of at most L in a box, in a sphere, within a radius of a line; may be given
                        several times
)"
  };
  return group;
}
} // namespace commandline
