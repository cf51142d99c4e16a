#include "pose_samples.h"

#include <algorithm>
#include <cmath>

#include "turns.h"

namespace ice_ice_baby {

namespace {

constexpr double kKept_s = 3.0;
constexpr std::size_t kMaxSamples = 4096;
constexpr double kRecent_s = 2.0;    ///< what rates and delays are measured over
constexpr double kJumpBack_s = 2.0;  ///< an older stamp is of a clock that jumped back
constexpr double kMax_m = 1e12;
constexpr double kWindow_s = 0.06;  ///< of a fit, either side
constexpr double kFitRate_hz = 30.0;
constexpr std::size_t kFewest = 3;    ///< samples of a fit
constexpr double kMaxTurn_rad = 2.5;  ///< within the window of a fit; beyond pi it is ambiguous
constexpr double kShortest_s = 5e-3;  ///< interval that a velocity is taken from
constexpr double kLongest_s = 0.5;    ///< after a longer interval the velocity is unknown

bool usable(const PoseSample& sample) {
  return std::isfinite(sample.stamp_s) && std::isfinite(sample.arrival_s) &&
         sample.pose.position.allFinite() && sample.pose.rotation.allFinite() &&
         sample.pose.position.cwiseAbs().maxCoeff() <= kMax_m;
}

}  // namespace

bool PoseSamples::teleports(const PoseSample& from, const PoseSample& to) const {
  const double distance_m = (to.pose.position - from.pose.position).norm();
  return distance_m > teleport_.distance_m &&
         distance_m > teleport_.speed_m_s * (to.stamp_s - from.stamp_s);
}

bool PoseSamples::add(const PoseSample& sample) {
  if (!usable(sample)) return false;
  const bool back = !empty() && (sample.arrival_s < latest_arrival_s_ ||
                                 sample.stamp_s < newest().stamp_s - kJumpBack_s);
  if (back) clear();
  latest_arrival_s_ = sample.arrival_s;
  Entry entry{sample, sample.arrival_s - sample.stamp_s, segment_};
  if (!empty()) {
    if (sample.stamp_s <= newest().stamp_s) return addLate(sample);
    entry.silence_s = sample.arrival_s - newest().stamp_s;
    if (teleports(newest(), sample)) entry.segment = ++segment_;
  }
  all_.push_back(entry);
  drop();
  return true;
}

bool PoseSamples::addLate(const PoseSample& sample) {
  const std::size_t next = firstSince(sample.stamp_s);
  if (next == 0 || all_[next].sample.stamp_s == sample.stamp_s) return false;
  const Entry& before = all_[next - 1];
  if (before.segment != all_[next].segment || teleports(before.sample, sample) ||
      teleports(sample, all_[next].sample)) {
    return false;
  }
  all_.insert(all_.begin() + std::ptrdiff_t(next), {sample, 0.0, before.segment});
  drop();
  return true;
}

void PoseSamples::drop() {
  while (all_.size() > kMaxSamples ||
         (all_.size() > 2 && all_[1].sample.stamp_s < newest().stamp_s - kKept_s)) {
    all_.pop_front();
  }
}

void PoseSamples::clear() {
  all_.clear();
  ++epoch_;
}

std::size_t PoseSamples::firstSince(double stamp_s) const {
  const auto found = std::lower_bound(
      all_.begin(), all_.end(), stamp_s,
      [](const Entry& entry, double stamp) { return entry.sample.stamp_s < stamp; });
  return static_cast<std::size_t>(found - all_.begin());
}

double PoseSamples::rate_hz() const {
  if (count() < 2) return 0.0;
  const std::size_t first = std::min(firstSince(newest().stamp_s - kRecent_s), count() - 2);
  return double(count() - 1 - first) / (newest().stamp_s - all_[first].sample.stamp_s);
}

double PoseSamples::interval_s() const {
  double largest_s = 0.0, second_s = 0.0;
  for (std::size_t k = std::max<std::size_t>(1, firstSince(newest().stamp_s - kRecent_s));
       k < count(); ++k) {
    if (all_[k].segment != all_[k - 1].segment) continue;
    const double interval_s = all_[k].sample.stamp_s - all_[k - 1].sample.stamp_s;
    second_s = std::max(second_s, std::min(interval_s, largest_s));
    largest_s = std::max(largest_s, interval_s);
  }
  return second_s > 0.0 ? second_s : largest_s;
}

double PoseSamples::latency_s() const {
  double smallest_s = newest().arrival_s - newest().stamp_s;
  for (std::size_t k = firstSince(newest().stamp_s - kRecent_s); k < count(); ++k) {
    smallest_s = std::min(smallest_s, all_[k].sample.arrival_s - all_[k].sample.stamp_s);
  }
  return smallest_s;
}

double PoseSamples::silence_s() const {
  double largest_s = latency_s();
  for (std::size_t k = firstSince(newest().stamp_s - kRecent_s); k < count(); ++k) {
    largest_s = std::max(largest_s, all_[k].silence_s);
  }
  return largest_s;
}

PoseSamples::Reading PoseSamples::at(double stamp_s, bool fit) const {
  const std::size_t next = firstSince(stamp_s);
  if (next == 0 || next == count()) {
    const Entry& nearest = next == 0 ? all_.front() : all_.back();
    return {Source::kRest, nearest.sample.pose, Vec3d::Zero(), Vec3d::Zero(), nearest.segment};
  }
  const Entry& before = all_[next - 1];
  const bool arrived = all_[next].sample.stamp_s == stamp_s;
  if (before.segment != all_[next].segment) {
    const Entry& there = arrived ? all_[next] : before;
    return {Source::kLine, there.sample.pose, Vec3d::Zero(), Vec3d::Zero(), there.segment};
  }
  Reading reading;
  const bool near = stamp_s - before.sample.stamp_s <= kWindow_s &&
                    all_[next].sample.stamp_s - stamp_s <= kWindow_s;
  if (fit && near && rate_hz() > kFitRate_hz && fitted(next - 1, stamp_s, reading)) return reading;
  return line(next - 1, next, stamp_s);
}

PoseSamples::Reading PoseSamples::end(bool fit) const {
  const double stamp_s = newest().stamp_s;
  Reading reading;
  if (fit && rate_hz() > kFitRate_hz && fitted(count() - 1, stamp_s, reading)) {
    reading.source = Source::kEnd;
    return reading;
  }
  std::size_t from = count() - 1;
  while (from > 0 && all_[from - 1].segment == all_.back().segment &&
         stamp_s - all_[from].sample.stamp_s < kShortest_s) {
    --from;
  }
  const double interval_s = stamp_s - all_[from].sample.stamp_s;
  if (interval_s >= kShortest_s && interval_s <= kLongest_s)
    reading = line(from, count() - 1, stamp_s);
  reading.source = Source::kEnd;
  reading.pose = newest().pose;
  reading.segment = all_.back().segment;
  return reading;
}

PoseSamples::Reading PoseSamples::line(std::size_t from, std::size_t to, double stamp_s) const {
  const PoseSample& a = all_[from].sample;
  const PoseSample& b = all_[to].sample;
  const double interval_s = b.stamp_s - a.stamp_s;
  const Vec3d turn = turnOf(a.pose.rotation.transpose() * b.pose.rotation);
  const double share = (stamp_s - a.stamp_s) / interval_s;
  Reading reading;
  reading.source = Source::kLine;
  reading.pose.position = a.pose.position + share * (b.pose.position - a.pose.position);
  reading.pose.rotation = a.pose.rotation * rotationBy(share * turn);
  reading.segment = all_[from].segment;
  // Over nearly equal stamps noise would be any velocity.
  std::size_t first = from;
  while (first > 0 && all_[first - 1].segment == reading.segment &&
         b.stamp_s - all_[first].sample.stamp_s < kShortest_s) {
    --first;
  }
  const PoseSample& c = all_[first].sample;
  const double long_s = b.stamp_s - c.stamp_s;
  if (long_s < kShortest_s) return reading;
  reading.velocity_m_s = (b.pose.position - c.pose.position) / long_s;
  reading.spin_rad_s =
      c.pose.rotation * turnOf(c.pose.rotation.transpose() * b.pose.rotation) / long_s;
  return reading;
}

/// Weights fall to zero at the ends of the window, so that samples enter and leave it smoothly.
/// @returns false if there are too few samples, or they turn too far
bool PoseSamples::fitted(std::size_t centre, double stamp_s, Reading& reading) const {
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  const Entry& origin = all_[centre];
  double sum_w = 0.0, sum_t = 0.0, sum_tt = 0.0;
  Vec6 sum_y = Vec6::Zero(), sum_ty = Vec6::Zero();
  std::size_t used = 0;
  for (std::size_t k = firstSince(stamp_s - kWindow_s); k < count(); ++k) {
    const Entry& entry = all_[k];
    const double t = entry.sample.stamp_s - stamp_s;
    if (t >= kWindow_s) break;
    if (entry.segment != origin.segment) continue;
    Vec6 y;
    y << entry.sample.pose.position - origin.sample.pose.position,
        turnOf(origin.sample.pose.rotation.transpose() * entry.sample.pose.rotation);
    if (y.tail<3>().norm() > kMaxTurn_rad) return false;
    const double w = 1.0 - (t / kWindow_s) * (t / kWindow_s);
    sum_w += w;
    sum_t += w * t;
    sum_tt += w * t * t;
    sum_y += w * y;
    sum_ty += w * t * y;
    ++used;
  }
  const double spread = sum_w * sum_tt - sum_t * sum_t;
  if (used < kFewest || spread <= std::pow(sum_w * kShortest_s, 2)) return false;
  const Vec6 slope = (sum_w * sum_ty - sum_t * sum_y) / spread;
  const Vec6 value = (sum_y - sum_t * slope) / sum_w;
  reading.source = Source::kFit;
  reading.pose.position = origin.sample.pose.position + value.head<3>();
  reading.pose.rotation = origin.sample.pose.rotation * rotationBy(value.tail<3>());
  reading.velocity_m_s = slope.head<3>();
  reading.spin_rad_s = origin.sample.pose.rotation * slope.tail<3>();
  reading.segment = origin.segment;
  return true;
}

}  // namespace ice_ice_baby
