#include "simulation/simulator.h"

#include <algorithm>
#include <atomic>
#include <chrono>

#include "base/machine_memory.h"
#include "base/parallel.h"
#include "ice_ice_baby/errors.h"
#include "loading/memory_need.h"
#include "spawn/spawn_particles.h"

namespace ice_ice_baby {

namespace {

/// Skin of the neighbour lists beyond the support radius, in spacings. Lists are valid until a
/// particle has moved half of it.
constexpr double kSkin = 0.3;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

const int kAllThreads = tbb::this_task_arena::max_concurrency();

}  // namespace

template <class Real>
Simulator<Real>::Simulator(const Scene& scene, int threads)
    : scene_(scene),
      mass_kg_(particleMass_kg(scene.fluid, scene.supportRadius_m())),
      arena_(std::min(threads > 0 ? threads : kAllThreads, kAllThreads)),
      particles_(spawnParticles<Real>(scene, spawns_)),
      temperature_(scene),
      colliders_(scene, scene.fluid.spacing_m / 2),
      neighbours_(static_cast<Real>(scene.supportRadius_m()),
                  static_cast<Real>(kSkin * scene.fluid.spacing_m)),
      substep_control_(scene) {
  // scene() returns the values in force
  if (scene.adaptsSubsteps()) scene_.solver.target_error = scene.promisedError();
  scene_.solver.substeps = scene.substeps();
  scene_.solver.relaxation = scene.relaxation();
  if (scene.hasPhases()) {
    phase_change_.emplace(scene_, spawns_, colliders_, springs_);
  }
  fluid_.emplace(scene, colliders_, phases());
  if (!scene.sources.empty()) sources_.emplace(scene);
  if (!scene.drains.empty()) drains_.emplace(scene);
  updateTemperature(0.0);
  arena_.execute([&] {
    findNeighbours();
    // Coincident particles that fall together would never be separated, as lists stay valid then.
    if (neighbours_.coincident()) particles_.position = particles_.predicted;
    joinSheets();
    if (phase_change_) phase_change_->begin(particles_, neighbours_, spawns_);
    if (!colliders_.empty()) expelWater();
    fluid_->updateDensity(particles_, neighbours_);
    updateReport();
  });
}

template <class Real>
const StepReport& Simulator<Real>::advanceFrame() {
  const auto start = Clock::now();
  ++report_.frame;
  report_.time_s = double(report_.frame) / scene_.solver.frame_rate_hz;
  report_.speed_limited = 0;
  report_.correction_limited = 0;
  updateTemperature(report_.time_s);
  report_.substeps = report_.asleep ? 0 : substep_control_.substeps();
  if (!report_.asleep) {
    arena_.execute([&] {
      runSubsteps();
      removeSpilled();
      if (drains_) drains_clock_.run([&] { drain(); });
      if (phase_change_) {
        phase_change_->advance(particles_, neighbours_, temperature_.celsius());
      }
      report_clock_.run([&] { updateReport(); });
      judgeQuality();
      updateSleep();
      chooseSubsteps(secondsSince(start));
    });
  }
  if (report_.substeps == 0 && wrench_meter_) {
    wrench_meter_->rest(1.0 / scene_.solver.frame_rate_hz);
  }
  if (sources_) sources_->endFrame();
  observeVessels();
  if (vessel_tracker_) vessel_tracker_->endFrame(report_.time_s);
  report_.frame_wall_s = secondsSince(start);
  return report_;
}

template <class Real>
void Simulator<Real>::judgeQuality() {
  const double weight = 1.0 / double(report_.frame);
  report_.density_error_run += weight * (report_.density_error_mean - report_.density_error_run);
  report_.promised_error = scene_.promisedError();
  report_.quality_met = report_.promised_error == 0.0
                            ? substep_control_.withinBudget(scene_)
                            : report_.density_error_run <= report_.promised_error;
}

template <class Real>
void Simulator<Real>::runSubsteps() {
  const auto bodiesLimited = [&] { return phase_change_ ? phase_change_->limited() : 0; };
  const std::uint64_t limited_before = bodiesLimited();
  const std::uint64_t cut_before = fluid_->correctionsLimited();
  if (colliders_moving_) jumpColliders();
  const int substeps = report_.substeps;
  for (int k = 0; k < substeps; ++k) {
    if (colliders_moving_) colliders_.setSubstep(double(k) / substeps, double(k + 1) / substeps);
    const double dt_s = 1.0 / (scene_.solver.frame_rate_hz * substeps);
    if (wrench_meter_) wrench_meter_->begin(particles_, bodies());
    substep(dt_s);
    if (wrench_meter_) endWrenches(dt_s);
    if (sources_) sources_clock_.run([&] { pour(k, substeps); });
  }
  report_.speed_limited += bodiesLimited() - limited_before;
  report_.correction_limited = fluid_->correctionsLimited() - cut_before;
  if (!colliders_moving_) return;
  colliders_.endFrame();
  colliders_.setSubstep(1.0, 1.0);
  colliders_moving_ = false;
}

/// Algorithm 1 of the paper, line by line.
template <class Real>
void Simulator<Real>::substep(double dt_s) {
  const Real dt = static_cast<Real>(dt_s);
  predict_clock_.run([&] { predict(dt_s); });
  if (fluid_->hasCoarseLevel()) coarse_clock_.run([&] { projectCoarse(dt_s); });
  fluid_->beginSubstep(particles_);
  if (phase_change_) phase_change_->conform(particles_.predicted);
  neighbours_clock_.run([&] { findNeighbours(); });
  if (strictness_ > 0.0) make_springs_clock_.run([&] { makeSprings(); });
  if (phase_change_) phase_change_->findContacts(particles_.predicted, neighbours_);

  for (int iteration = 0; iteration < scene_.solver.iterations; ++iteration) {
    fluid_->iterate(particles_, neighbours_);
    if (!colliders_.empty()) collide_clock_.run([&] { respondToCollisions(); });
    // The paper corrects springs before the update of x*, the default after; see doc/algorithm.md.
    if (!scene_.springs.correct_updated) correctSprings(dt_s, iteration);
    position_clock_.run([&] { updatePredicted(); });
    if (phase_change_) phase_change_->moveBodies(particles_.predicted);
    if (scene_.springs.correct_updated) correctSprings(dt_s, iteration);
  }
  const bool moved_since_response = springsCorrect() || scene_.solver.iterations == 0;
  if (moved_since_response && !colliders_.empty()) collide_clock_.run([&] { finishCollisions(); });
  if (phase_change_) phase_change_->contain(particles_.predicted);

  velocity_clock_.run([&] { updateVelocityAndPosition(dt); });
  if (phase_change_) phase_change_->finish(particles_);
  if (fluid_->viscous()) viscosity_clock_.run([&] { applyViscosity(dt_s); });
}

template <class Real>
void Simulator<Real>::predict(double dt_s) {
  applyForcesAndPredict(static_cast<Real>(dt_s));
  if (phase_change_) phase_change_->predict(particles_, dt_s);
}

template <class Real>
void Simulator<Real>::applyForcesAndPredict(Real dt) {
  const Vec3<Real> gravity = scene_.gravity_m_s2.cast<Real>();
  parallelFor(particles_.owned(), [&](std::size_t i) {
    const Vec3<Real> v = particles_.velocity.at(i) + dt * gravity;
    particles_.velocity.set(i, v);
    particles_.predicted.set(i, particles_.position.at(i) + dt * v);
  });
}

template <class Real>
void Simulator<Real>::projectCoarse(double dt_s) {
  fluid_->projectCoarse(particles_, bodies(), scene_.gravity_m_s2.cast<Real>(),
                        static_cast<Real>(dt_s));
  if (wrench_meter_) wrench_meter_->addCoarse(*fluid_, particles_, static_cast<Real>(dt_s));
}

template <class Real>
void Simulator<Real>::makeSprings() {
  if (springs_ && springs_->kept()) return;
  if (!springs_) springs_.emplace(scene_.springs);
  const double reach = scene_.springs.reach_h * scene_.supportRadius_m();
  springs_->make(particles_, neighbours_, phases(), static_cast<Real>(reach));
  if (frozen() && scene_.springs.keep_frozen) springs_->keep();
}

template <class Real>
void Simulator<Real>::correctSprings(double dt_s, int iteration) {
  if (!springsCorrect()) return;
  correct_springs_clock_.run([&] {
    const bool begins = iteration == 0;
    if (scene_.thermal.enabled) {
      springs_->correctElastic(particles_.predicted, scene_.ice.compliance_m_n, mass_kg_, dt_s,
                               begins);
    } else {
      springs_->correct(particles_.predicted, strictness_, mass_kg_, dt_s, begins);
    }
  });
}

template <class Real>
void Simulator<Real>::updatePredicted() {
  const VectorField<Real>& delta_p = fluid_->deltaP();
  parallelFor(particles_.size(),
              [&](std::size_t i) { particles_.predicted.add(i, delta_p.at(i)); });
}

/// v = (x* - x) / dt, x = x*, written as the change by the corrections, so that free flight keeps
/// every bit of its velocity in any substep. A particle with a value that is not finite is put at
/// rest at its previous position; one above the speed limit is slowed to it. Both are counted.
template <class Real>
void Simulator<Real>::updateVelocityAndPosition(Real dt) {
  const Real limit = static_cast<Real>(scene_.solver.max_speed_m_s);
  std::atomic<std::uint64_t> limited{0}, repaired{0};
  parallelFor(particles_.owned(), [&](std::size_t i) {
    Vec3<Real> v = particles_.velocity.at(i);
    const Vec3<Real> flight = particles_.position.at(i) + dt * v;
    v += (particles_.predicted.at(i) - flight) / dt;
    if (!v.allFinite()) {
      v.setZero();
      particles_.predicted.set(i, particles_.position.at(i));
      repaired.fetch_add(1, std::memory_order_relaxed);
    }
    const Real speed = v.norm();
    if (speed > limit) {
      v *= limit / speed;
      limited.fetch_add(1, std::memory_order_relaxed);
    }
    particles_.velocity.set(i, v);
    particles_.position.set(i, particles_.predicted.at(i));
  });
  report_.speed_limited += limited;
  report_.non_finite += repaired;
  if (repaired > 0) forgetCorrections();  // otherwise every substep would start from it again
}

template <class Real>
void Simulator<Real>::applyViscosity(double dt_s) {
  fluid_->applyViscosity(particles_, neighbours_, dt_s);
  if (phase_change_) phase_change_->takeVelocities(particles_);
}

std::unique_ptr<Simulation> makeSimulation(const Scene& scene, Precision precision, int threads) {
  requireInRange("threads", threads, 0, 1024);
  validate(scene);
  requireMemory(scene, machineMemory_bytes());
  if (precision == Precision::kDouble) return std::make_unique<Simulator<double>>(scene, threads);
  return std::make_unique<Simulator<float>>(scene, threads);
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
