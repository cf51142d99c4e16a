#include "leaks/motions.h"

#include <cmath>
#include <random>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby::leaks {

namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : generator_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  Vec3d gauss(double deviation) {
    std::normal_distribution<double> normal(0.0, deviation);
    const double x = normal(generator_), y = normal(generator_), z = normal(generator_);
    return {x, y, z};
  }
  Vec3d direction() { return gauss(1.0).normalized(); }

 private:
  std::mt19937_64 generator_;
};

/// To and fro along an axis that changes after every period, at up to 10 m/s.
class Shaken : public VesselMotion {
 public:
  explicit Shaken(unsigned seed) : dice_(seed) {}

  Posed at(double time_s) override {
    const double turns = kRate_rad_s * time_s / (2 * M_PI);
    while (periods_ <= turns) {
      axis_ = dice_.direction();
      speed_m_s_ = dice_.uniform(3.0, 10.0);
      ++periods_;
    }
    Posed pose;
    pose.position = speed_m_s_ / kRate_rad_s * (1 - std::cos(kRate_rad_s * time_s)) * axis_;
    return pose;
  }

 private:
  static constexpr double kRate_rad_s = 100.0;
  Dice dice_;
  int periods_ = 0;
  Vec3d axis_ = Vec3d::UnitX();
  double speed_m_s_ = 0.0;
};

/// Turns at up to 20 rad/s about an axis that changes every 0.2 s.
class Tumbled : public VesselMotion {
 public:
  explicit Tumbled(unsigned seed) : dice_(seed) {}

  Posed at(double time_s) override {
    while (drawn_ * kEach_s <= time_s) {
      axis_ = dice_.direction();
      rate_rad_s_ = dice_.uniform(5.0, 20.0);
      ++drawn_;
    }
    pose_.rotation = Eigen::AngleAxisd(rate_rad_s_ * (time_s - last_s_), axis_) *
                     Eigen::Quaterniond(pose_.rotation).normalized();
    last_s_ = time_s;
    return pose_;
  }

 private:
  static constexpr double kEach_s = 0.2;
  Dice dice_;
  int drawn_ = 0;
  Vec3d axis_ = Vec3d::UnitX();
  double rate_rad_s_ = 0.0, last_s_ = 0.0;
  Posed pose_;
};

/// Turns about its own axis, either way at up to 60 rad/s.
class Spun : public VesselMotion {
 public:
  Posed at(double time_s) override {
    Posed pose;
    const double angle = kTop_rad_s / kRate_rad_s * (1 - std::cos(kRate_rad_s * time_s));
    pose.rotation = Eigen::AngleAxisd(angle, Vec3d::UnitZ()).toRotationMatrix();
    return pose;
  }

 private:
  static constexpr double kTop_rad_s = 60.0, kRate_rad_s = M_PI / 0.6;
};

/// How poses arrive: samples of a slow path, each held until the next.
struct Sampling {
  double rate_hz;
  double noise_m = 0.0, noise_rad = 0.0;
  double gap_s = 0.0;       ///< without samples at the start of every kGapPeriod_s
  double teleport_m = 0.0;  ///< distance of the other place, to which it goes every half second
};

class Sampled : public VesselMotion {
 public:
  Sampled(unsigned seed, const Sampling& sampling) : dice_(seed), sampling_(sampling) {
    away_ = sampling.teleport_m * dice_.direction();
  }

  Posed at(double time_s) override {
    const long sample = std::lround(std::floor(time_s * sampling_.rate_hz * (1 + 1e-12)));
    const bool missing =
        sampling_.gap_s > 0 && std::fmod(time_s, kGapPeriod_s) < sampling_.gap_s && sample > 0;
    if (sample == last_ || missing) return held_;
    last_ = sample;
    held_ = path(double(sample) / sampling_.rate_hz);
    held_.position += dice_.gauss(sampling_.noise_m);
    const Vec3d turn = dice_.gauss(sampling_.noise_rad);
    const double angle = turn.norm();
    if (angle > 0) held_.rotation = Eigen::AngleAxisd(angle, turn / angle) * held_.rotation;
    return held_;
  }

 private:
  /// A circle of 5 cm at 0.1 m/s, tilting by up to 0.2 rad.
  Posed path(double time_s) const {
    const double angle = 2.0 * time_s;
    Posed pose;
    pose.position = 0.05 * Vec3d(std::cos(angle) - 1, std::sin(angle), 0);
    if (std::fmod(time_s, 1.0) >= 0.5) pose.position += away_;
    pose.rotation = Eigen::AngleAxisd(0.2 * std::sin(angle), Vec3d::UnitX()).toRotationMatrix();
    return pose;
  }

  static constexpr double kGapPeriod_s = 0.6;
  Dice dice_;
  Sampling sampling_;
  Vec3d away_;
  long last_ = -1;
  Posed held_;
};

constexpr double kNoise_m = 0.002, kNoise_rad = M_PI / 180;

const std::vector<std::pair<const char*, Sampling>> kSampled{
    {"jerked_5", {5, kNoise_m, kNoise_rad}},
    {"jerked_20", {20, kNoise_m, kNoise_rad}},
    {"jerked_100", {100, kNoise_m, kNoise_rad}},
    {"jerked_1000", {1000, kNoise_m, kNoise_rad}},
    {"gaps", {100, 0.0, 0.0, 0.3}},
    {"teleported", {100, 0.0, 0.0, 0.0, 1.0}}};

}  // namespace

std::vector<std::string> motionNames() {
  std::vector<std::string> names;
  for (const auto& [name, sampling] : kSampled) names.emplace_back(name);
  names.insert(names.end(), {"spun", "shaken", "tumbled"});
  return names;
}

std::unique_ptr<VesselMotion> makeMotion(const std::string& name, unsigned seed) {
  if (name == "shaken") return std::make_unique<Shaken>(seed);
  if (name == "tumbled") return std::make_unique<Tumbled>(seed);
  if (name == "spun") return std::make_unique<Spun>();
  for (const auto& [known, sampling] : kSampled) {
    if (name == known) return std::make_unique<Sampled>(seed, sampling);
  }
  throw InvalidInput("no motion " + shortened(name) + "; there are: " + joined(motionNames()));
}

}  // namespace ice_ice_baby::leaks
