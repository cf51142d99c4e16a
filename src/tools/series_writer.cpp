#include "series_writer.h"

#include <algorithm>

#include "base/shortest_text.h"
#include "ice_ice_baby/errors.h"
#include "metrics/cloud_moments.h"
#include "resident_memory.h"

namespace ice_ice_baby {

namespace {

constexpr char kParticleColumns[] =
    "id,x,y,z,vx,vy,vz,density,pressure_pa,temperature_c,ice_fraction,phase\n";

/// A row of the table and the names of its columns.
class Row {
 public:
  void add(const std::string& name, double value) {
    const char* comma = names_.empty() ? "" : ",";
    names_ += comma + name;
    values_ += comma + numberText(value);
  }
  /// @param name with {} where the axis belongs
  void add(const std::string& name, const Vec3d& vector) {
    const std::size_t at = name.rfind("{}");
    for (int k = 0; k < 3; ++k) add(std::string(name).replace(at, 2, 1, "xyz"[k]), vector[k]);
  }

  const std::string& names() const { return names_; }
  const std::string& values() const { return values_; }

 private:
  std::string names_, values_;
};

void addMoments(Row& row, const CloudMoments& moments) {
  row.add("min_{}_m", moments.min_m);
  row.add("max_{}_m", moments.max_m);
  row.add("mean_{}_m", moments.mean_m);
  row.add("rms_{}_m", moments.rms_m);
  row.add("momentum_{}_kg_m_s", moments.momentum_kg_m_s);
  row.add("angular_momentum_{}_kg_m2_s", moments.angular_momentum_kg_m2_s);
}

/// All that the frame reports, but where the table has a column of its own: density errors by the
/// kernel that all solvers are compared with are called as those of the solver's own kernel are.
void addReport(Row& row, const StepReport& report) {
  const auto add = [&](const std::string& name, const auto& value, const char*) {
    const bool own_kernel = name.rfind("density_error", 0) == 0;
    if (name != "time_s") row.add((own_kernel ? "own_" : "") + name, double(value));
  };
  describeReproducible(add, report);
}

/// Without commas, which separate columns.
std::string columnName(std::string name) {
  std::replace(name.begin(), name.end(), ',', '_');
  return name;
}

void addVessels(Row& row, const Simulation& simulation) {
  for (const VesselReport& vessel : simulation.vessels()) {
    const std::string name = columnName(vessel.name);
    row.add(name + ".water_m3", vessel.water_m3);
    row.add(name + ".ice_m3", vessel.ice_m3);
    row.add(name + ".level_m", vessel.level_m);
  }
}

void addWrenches(Row& row, const std::vector<ColliderWrench>& wrenches) {
  for (const ColliderWrench& wrench : wrenches) {
    row.add(columnName(wrench.name) + ".force_{}_n", wrench.force_n);
    row.add(columnName(wrench.name) + ".torque_{}_n_m", wrench.torque_n_m);
  }
}

Row rowOf(const FrameView& frame) {
  const StepReport& report = frame.report();
  Row row;
  row.add("time_s", report.time_s);
  row.add("wall_s", frame.frame_wall_s);
  row.add("density_error_mean", frame.error.mean);
  row.add("density_error_max", frame.error.max);
  addReport(row, report);
  row.add("total_energy_j",
          report.kinetic_energy_j + report.potential_energy_j + report.elastic_energy_j);
  addMoments(row, momentsOf(frame.particles, massOfParticle_kg(frame.scene())));
  addVessels(row, frame.simulation);
  addWrenches(row, frame.wrenches);
  row.add("resident_bytes", double(residentBytes()));
  return row;
}

void requireGood(const std::ofstream& file, const std::string& what, const std::string& path) {
  if (!file) throw InvalidInput("cannot write the " + what + " to " + path);
}

}  // namespace

SeriesWriter::SeriesWriter(std::string path) : path_(std::move(path)), file_(path_) {
  requireGood(file_, "series", path_);
}

void SeriesWriter::add(const FrameView& frame) {
  const Row row = rowOf(frame);
  if (!named_) file_ << row.names() << "\n";
  named_ = true;
  // A run that is stopped leaves every frame it finished.
  file_ << row.values() << "\n" << std::flush;
  requireGood(file_, "series", path_);
}

void writeParticles(const std::string& path, const Simulation& simulation) {
  std::vector<ParticleSample> particles;
  simulation.sample(particles);
  std::ofstream file(path);
  file << kParticleColumns;
  for (const ParticleSample& p : particles) {
    std::string row = std::to_string(p.id);
    for (const float value : {p.x, p.y, p.z, p.vx, p.vy, p.vz, p.density, p.pressure_pa,
                              p.temperature_c, p.ice_fraction}) {
      row += "," + shortestText(value);
    }
    file << row << "," << int(p.phase) << "\n";
  }
  file.close();
  requireGood(file, "particles", path);
}

}  // namespace ice_ice_baby
