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

const std::set<std::string>& sides()
{
  static const std::set<std::string> names = { "xmin", "xmax", "ymin", "ymax", "zmin", "zmax" };
  return names;
}

// SIDE=NAME or SIDE=NAME:TYPE.
SideOption sideOf(const std::string& word)
{
  const std::size_t equals = word.find('=');
  const std::size_t colon = word.find(':');
  const std::size_t begin = equals + 1;
  if (equals == std::string::npos || !sides().contains(word.substr(0, equals)) || begin == word.size() ||
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

MarginOption marginOf(const std::string& word, const std::string& option)
{
  const std::string form = "SIDE=M, as in xmax=20";
  const auto [side, value] = assignmentOf(word, option, form);
  const double margin = finiteNumber(value, option);
  if (!sides().contains(side) || margin <= 0)
  {
    throw UsageError(option + " needs " + form + ", not " + word);
  }
  return { side, margin };
}

void addMargins(Options& options, Arguments& arguments, const std::string& option)
{
  for (const std::string& word : valuesOf(arguments, option))
  {
    options.margins.push_back(marginOf(word, option));
  }
}

void addTypes(Options& options, Arguments& arguments, const std::string& option)
{
  for (const std::string& word : valuesOf(arguments, option))
  {
    options.typesOfPatterns.push_back(assignmentOf(word, option, "PATCH=TYPE, as in duct=wall"));
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
    options.ground.axis > 0 || !options.keptInsides.empty() || options.radiusEdgeRatio > 0 ||
    options.dihedralAngle >= 0;
  if (options.isMesh() && isShaped)
  {
    throw UsageError(
      "options for the domain have no meaning: " + options.surfaces.front() + " is a mesh already");
  }
  const bool hasBox = options.farField > 0 && !options.sphere;
  if (!options.sides.empty() && !hasBox)
  {
    throw UsageError("--side names the sides of the box that --far-field makes: give that, too");
  }
  if (!options.margins.empty() && !hasBox)
  {
    throw UsageError("--margin moves sides of the box that --far-field makes: give that, too");
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
      { "--margin", addMargins },
      { "--side", addSides },
      { "--patch-type", addTypes },
      { "--feature-angle", [](O& o, A& a, S& name) { o.featureAngle = numberBetween(a, name, 0, 180); } },
      { "--radius-edge-ratio",
        [](O& o, A& a, S& name) { o.radiusEdgeRatio = numberBetween(a, name, 1.1, 10); } },
      { "--dihedral-angle", [](O& o, A& a, S& name) { o.dihedralAngle = numberBetween(a, name, 0, 18); } },
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
  --margin SIDE=M...    other margins of sides of the box, in body lengths: xmin=5 xmax=20
  --side SIDE=NAME[:TYPE]...
                        names sides of the box: xmin=inlet xmax=outlet zmax=top:symmetry; what is
                        not told of the type, the name suggests; sides of one name are one patch
  --patch-type PATCH=TYPE...
                        types of patches (names, wildcards), where their names tell none or wrong ones:
                        duct=wall; wall, symmetry, farfield, inlet, outlet, wake, interface or patch
  --feature-angle A     remeshing keeps edges that turn by more than A degrees (30); the outer faces of
                        a mesh without patches are parted there
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
  --radius-edge-ratio R largest ratio of circumradius to shortest edge of tetrahedra, 1.1 to 10 (1.4)
  --dihedral-angle A    smallest dihedral angle of tetrahedra, 0 to 18 degrees (10)
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
