// How a quantity is distributed: quantiles and histograms.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ransmesh
{
struct Quantiles
{
  static constexpr std::array<double, 8> Percents = { 0, 1, 5, 50, 95, 99, 99.9, 100 };

  std::size_t count = 0; // of values; the rest means nothing where it is 0
  double mean = 0;
  std::array<double, Percents.size()> at{}; // linear between neighbouring values

  double lowest() const { return at.front(); }
  double median() const { return at[3]; }
  double highest() const { return at.back(); }
};

// In linear time. NaN are left out.
Quantiles quantilesOf(std::vector<double> values);

struct Histogram
{
  std::string quantity;
  std::string unit;
  std::string scope;              // "whole", "layers" or a patch's name
  std::vector<double> low;        // of each bin; a value on a border belongs to the bin above it
  std::vector<double> high;       // of each bin; the last one holds its upper border
  std::vector<std::size_t> count; // of each bin; values beyond the ends are in the first and last bin
};

// Bins of equal width.
Histogram evenHistogram(const std::vector<double>& values, double low, double high, int bins);

// From 1 to the power of ten that holds the largest value, perDecade bins for each factor of ten.
Histogram decadeHistogram(const std::vector<double>& values, int perDecade);
} // namespace ransmesh
