#include "FoamFile.h"

namespace ransmesh::foam
{
std::string header(
  const std::string& object, const std::string& className, bool binary, const std::string& note)
{
  std::string text = "FoamFile\n{\n    version     2.0;\n";
  text += std::string("    format      ") + (binary ? "binary" : "ascii") + ";\n";
  text += std::string("    arch        \"") + (std::endian::native == std::endian::little ? "LSB" : "MSB") +
    ";label=32;scalar=64\";\n";
  text += "    class       " + className + ";\n";
  text += note.empty() ? "" : "    note        \"" + note + "\";\n";
  text += "    location    \"constant/polyMesh\";\n    object      " + object + ";\n}\n\n";
  return text;
}
} // namespace ransmesh::foam
