#include "metrics/martin_moyce.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ice_ice_baby {

namespace {

constexpr double kFirst = 1.2;
constexpr double kLast = 4.0;

double frontAt(const std::vector<FrontPoint>& run, double time) {
  const auto after = std::lower_bound(run.begin(), run.end(), time,
                                      [](const FrontPoint& p, double t) { return p.time < t; });
  if (after == run.begin()) return after->front;
  const FrontPoint& before = *(after - 1);
  const double part = (time - before.time) / (after->time - before.time);
  return before.front + part * (after->front - before.front);
}

}  // namespace

const std::vector<FrontPoint>& martinMoyceWide() {
  static const std::vector<FrontPoint> points{
      {.832, 1.217},  {1.219, 1.474},  {1.997, 2.292},  {2.547, 2.995},  {3.345, 4.134},
      {4.034, 4.944}, {4.418, 5.881},  {5.091, 6.980},  {5.685, 7.945},  {6.306, 8.966},
      {6.822, 9.986}, {7.439, 10.963}, {8.031, 11.977}, {8.633, 13.005}, {9.237, 13.970}};
  return points;
}

const std::vector<FrontPoint>& martinMoyceNarrow() {
  static const std::vector<FrontPoint> points{
      {.849, 1.245},  {1.212, 1.443}, {1.602, 1.884}, {2.283, 2.689}, {2.950, 3.728},
      {3.598, 4.528}, {3.905, 4.999}, {4.592, 5.841}, {4.961, 6.271}, {5.316, 6.717}};
  return points;
}

double frontError(const std::vector<FrontPoint>& run, const std::vector<FrontPoint>& measured) {
  if (run.empty() || run.back().time < kLast) return std::numeric_limits<double>::quiet_NaN();
  double squares = 0.0;
  std::size_t count = 0;
  for (const FrontPoint& point : measured) {
    if (point.time < kFirst || point.time > kLast) continue;
    const double relative = frontAt(run, point.time) / point.front - 1.0;
    squares += relative * relative;
    ++count;
  }
  return std::sqrt(squares / double(count));
}

}  // namespace ice_ice_baby
