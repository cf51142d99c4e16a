// Lists all state of a simulator, and writes, hashes and restores it.
#include <cstdint>

#include "checkpoint/restored_state.h"
#include "checkpoint/scene_archive.h"
#include "loading/mesh_files.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

namespace {

/// Written in place of PhaseChange if the scene has neither heat nor solids.
struct NoPhaseChange {
  bool bodies = false, contacts = false;
  double heat_due_s = 0.0, phases_due_s = 0.0;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.bodies, self.contacts);
  }
  template <class Self, class Archive>
  static void exchangeTimes(Self& self, Archive& archive) {
    archive(self.heat_due_s, self.phases_due_s);
  }
  void restore() const {
    requireValid(!bodies && !contacts, "ice bodies in a scene without rigid ice");
    requireValid(heat_due_s == 0.0 && phases_due_s == 0.0, "temperatures in a scene without heat");
  }
};

}  // namespace

/// All state that determines future frames, except the scene.
template <class Real>
template <class Self, class Archive>
void Simulator<Real>::exchange(Self& self, Archive& archive) {
  archive(self.particles_, self.neighbours_, self.temperature_, self.colliders_, *self.fluid_);
  archive.optional(self.springs_, self.scene_.springs);
  NoPhaseChange none;
  if (self.phase_change_) archive(*self.phase_change_);
  if (!self.phase_change_) archive(none);
  archive(self.substep_control_, self.strictness_);
  if (self.phase_change_) PhaseChange<Real>::exchangeTimes(*self.phase_change_, archive);
  if (!self.phase_change_) NoPhaseChange::exchangeTimes(none, archive);
  none.restore();
  if (self.sources_) archive(*self.sources_);
  if (self.drains_) archive(*self.drains_);
  archive(self.still_s_, self.colliders_moving_, self.report_.asleep);
}

template <class Real>
void Simulator<Real>::writeState(StateWriter& writer) const {
  Scene described = scene_;
  describe(described, SceneArchive<StateWriter>(writer));
  for (const Mesh& mesh : scene_.meshes) writer(checksumOf(*mesh.triangles));
  writer(std::uint32_t(particles_.size()), particles_.next_id - spawned());
  exchange(*this, writer);
}

template <class Real>
void Simulator<Real>::write(StateWriter& writer) const {
  writeState(writer);
  writer(report_);
}

template <class Real>
void Simulator<Real>::read(StateReader& reader, std::uint32_t particles, std::uint32_t came) {
  particles_.next_id = spawned() + came;
  exchange(*this, reader);
  reader(report_);
  restore(particles);
}

/// FNV-1a.
template <class Real>
std::uint64_t Simulator<Real>::stateHash() const {
  StateWriter writer;
  writeState(writer);
  std::uint64_t hash = 14695981039346656037ull;
  for (const char byte : writer.bytes()) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ull;
  }
  return hash;
}

template <class Real>
Precision Simulator<Real>::precision() const {
  return sizeof(Real) == sizeof(double) ? Precision::kDouble : Precision::kFloat;
}

template class Simulator<float>;
template class Simulator<double>;

}  // namespace ice_ice_baby
