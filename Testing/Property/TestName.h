// Names of parametrised tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

// The parameter's name, with underscores for what test names may not hold.
template <class Parameter>
std::string testName(const testing::TestParamInfo<Parameter>& info)
{
  std::string name = info.param.name;
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
  return name;
}
