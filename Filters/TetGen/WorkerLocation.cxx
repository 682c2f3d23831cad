#include "WorkerLocation.h"

#include <vtksys/SystemTools.hxx>

#include <dlfcn.h>

#include <vector>

namespace ransmesh
{
namespace
{
constexpr const char* ProgramName = "ransmesh-tetgen-worker";

bool isProgram(const std::string& path)
{
  return vtksys::SystemTools::FileExists(path, true) &&
    vtksys::SystemTools::TestFileAccess(path, vtksys::TEST_FILE_EXECUTE);
}

std::string libraryFolder()
{
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&findWorker), &info) == 0 || !info.dli_fname)
  {
    return "";
  }
  return vtksys::SystemTools::GetFilenamePath(vtksys::SystemTools::GetRealPath(info.dli_fname));
}

std::vector<std::string> places(const std::string& wanted)
{
  if (!wanted.empty())
  {
    return { wanted };
  }
  std::string fromEnvironment;
  if (vtksys::SystemTools::GetEnv("RANSMESH_WORKER", fromEnvironment) && !fromEnvironment.empty())
  {
    return { fromEnvironment };
  }
  const std::string folder = libraryFolder() + "/";
  std::vector<std::string> all = { folder + RANSMESHING_WORKER_FROM_LIBRARY };
  for (const char* way : { "", "../bin/", "../libexec/", "../../bin/", "../../../bin/", "../../../../bin/" })
  {
    all.push_back(folder + way + ProgramName);
  }
  const std::string onPath = vtksys::SystemTools::FindProgram(ProgramName);
  if (!onPath.empty())
  {
    all.push_back(onPath);
  }
  return all;
}
} // namespace

std::string findWorker(const std::string& wanted, std::string& tried)
{
  tried.clear();
  for (const std::string& place : places(wanted))
  {
    const std::string path = vtksys::SystemTools::CollapseFullPath(place);
    if (isProgram(path))
    {
      return path;
    }
    if (tried.find(path) == std::string::npos)
    {
      tried += (tried.empty() ? "" : ", ") + path;
    }
  }
  return "";
}
} // namespace ransmesh
