#include "Quality/Distribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ransmesh
{
namespace
{
std::size_t binOf(const std::vector<double>& low, double value)
{
  const auto after = std::upper_bound(low.begin(), low.end(), value);
  return after == low.begin() ? 0 : static_cast<std::size_t>(after - low.begin() - 1);
}

void countInto(Histogram& histogram, const std::vector<double>& values)
{
  histogram.count.assign(histogram.low.size(), 0);
  for (const double value : values)
  {
    ++histogram.count[binOf(histogram.low, value)];
  }
}
} // namespace

Quantiles quantilesOf(std::vector<double> values)
{
  // Coordinates near the end of the range overflow into NaN, by which nothing can be sorted.
  values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return std::isnan(value); }),
    values.end());
  Quantiles result;
  result.count = values.size();
  if (values.empty())
  {
    return result;
  }
  result.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  auto begin = values.begin(); // all before it is no larger than all after it
  for (std::size_t i = 0; i < Quantiles::Percents.size(); ++i)
  {
    const double place = Quantiles::Percents[i] / 100 * static_cast<double>(values.size() - 1);
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::floor(place));
    std::nth_element(begin, at, values.end());
    const double next = at + 1 == values.end() ? *at : *std::min_element(at + 1, values.end());
    const double part = place - std::floor(place);
    result.at[i] = part > 0 ? *at + part * (next - *at) : *at;
    begin = at;
  }
  return result;
}

Histogram evenHistogram(const std::vector<double>& values, double low, double high, int bins)
{
  Histogram histogram;
  for (int i = 0; i < bins; ++i)
  {
    histogram.low.push_back(low + (high - low) * i / bins);
    histogram.high.push_back(low + (high - low) * (i + 1) / bins);
  }
  countInto(histogram, values);
  return histogram;
}

Histogram decadeHistogram(const std::vector<double>& values, int perDecade)
{
  const double largest = values.empty() ? 1 : *std::max_element(values.begin(), values.end());
  const int decades = std::clamp(static_cast<int>(std::ceil(std::log10(std::max(largest, 1.0)))), 1, 308);
  Histogram histogram;
  for (int i = 0; i < decades * perDecade; ++i)
  {
    histogram.low.push_back(std::pow(10.0, static_cast<double>(i) / perDecade));
    histogram.high.push_back(std::pow(10.0, static_cast<double>(i + 1) / perDecade));
  }
  countInto(histogram, values);
  return histogram;
}
} // namespace ransmesh
