#include "series_writer.h"

#include "base/shortest_text.h"
#include "ice_ice_baby/errors.h"
#include "metrics/cloud_moments.h"
#include "resident_memory.h"

namespace ice_ice_baby {

namespace {

constexpr char kSeriesColumns[] =
    "time_s,wall_s,density_error_mean,density_error_max,own_density_error_mean,"
    "own_density_error_max,kinetic_energy_j,potential_energy_j,elastic_energy_j,"
    "total_energy_j,rms_speed_m_s,max_speed_m_s,min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,"
    "mean_x_m,mean_y_m,mean_z_m,rms_x_m,rms_y_m,rms_z_m,momentum_x_kg_m_s,momentum_y_kg_m_s,"
    "momentum_z_kg_m_s,"
    "angular_momentum_x_kg_m2_s,angular_momentum_y_kg_m2_s,angular_momentum_z_kg_m2_s,"
    "temperature_c,strictness,springs,mean_celsius,enthalpy_j,thermal_speedup,ice_bodies,ice_"
    "bodies_asleep,"
    "ice_particles,steam_particles,resident_bytes\n";
constexpr char kParticleColumns[] =
    "id,x,y,z,vx,vy,vz,density,pressure_pa,temperature_c,ice_fraction\n";

void append(std::string& row, double value) { row += (row.empty() ? "" : ",") + numberText(value); }

void append(std::string& row, const Vec3d& vector) {
  for (const double part : vector) append(row, part);
}

void requireGood(const std::ofstream& file, const std::string& what, const std::string& path) {
  if (!file) throw InvalidInput("cannot write the " + what + " to " + path);
}

}  // namespace

SeriesWriter::SeriesWriter(std::string path) : path_(std::move(path)), file_(path_) {
  file_ << kSeriesColumns << std::flush;
  requireGood(file_, "series", path_);
}

void SeriesWriter::add(const FrameView& frame) {
  const StepReport& report = frame.report();
  const CloudMoments moments = momentsOf(frame.particles, massOfParticle_kg(frame.scene()));
  std::string row;
  for (const double value :
       {report.time_s, frame.frame_wall_s, frame.error.mean, frame.error.max,
        report.density_error_mean, report.density_error_max, report.kinetic_energy_j,
        report.potential_energy_j, report.elastic_energy_j,
        report.kinetic_energy_j + report.potential_energy_j + report.elastic_energy_j,
        report.rms_speed_m_s, report.max_speed_m_s}) {
    append(row, value);
  }
  for (const Vec3d& vector : {moments.min_m, moments.max_m, moments.mean_m, moments.rms_m,
                              moments.momentum_kg_m_s, moments.angular_momentum_kg_m2_s}) {
    append(row, vector);
  }
  for (const double value :
       {report.temperature_c, report.strictness, double(report.springs), report.mean_celsius,
        report.enthalpy_j, report.thermal_speedup, double(report.ice_bodies),
        double(report.ice_bodies_asleep), double(report.ice_particles),
        double(report.steam_particles), double(residentBytes())}) {
    append(row, value);
  }
  file_ << row << "\n" << std::flush;  // a run that is stopped leaves every frame it finished
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
    file << row << "\n";
  }
  file.close();
  requireGood(file, "particles", path);
}

}  // namespace ice_ice_baby
