// All state of a simulator as one list, and what is made of it: bytes, their hash, the way back.
#include <cstdint>

#include "checkpoint/scene_archive.h"
#include "simulation/simulator.h"

namespace ice_ice_baby {

// Whoever adds a member to the report adds it to StepReport::exchange too, and then sets this anew.
static_assert(sizeof(void*) != 8 || sizeof(StepReport) == 208, "list the member in exchange");

/// All that decides on the frames to come, but for the scene.
template <class Real>
template <class Self, class Archive>
void Simulator<Real>::exchange(Self& self, Archive& archive) {
  archive(self.particles_, self.neighbours_, self.temperature_, self.colliders_, *self.fluid_);
  archive.optional(self.springs_, self.scene_.springs);
  archive.optional(self.bodies_, self.scene_);
  archive.optional(self.contacts_, self.scene_);
  if (self.heat_) archive(*self.heat_, *self.phases_);
  archive(self.substeps_, self.strictness_, self.heat_due_s_, self.phases_due_s_, self.still_s_,
          self.colliders_moving_, self.report_.asleep);
}

template <class Real>
void Simulator<Real>::writeState(StateWriter& writer) const {
  Scene described = scene_;
  describe(described, SceneArchive<StateWriter>(writer));
  writer(std::uint64_t(particles_.size()));
  exchange(*this, writer);
}

template <class Real>
void Simulator<Real>::write(StateWriter& writer) const {
  writeState(writer);
  writer(report_);
}

template <class Real>
void Simulator<Real>::read(StateReader& reader) {
  exchange(*this, reader);
  reader(report_);
  settle();
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
