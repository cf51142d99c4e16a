#include "sequences/frame_outputs.h"

#include <chrono>

namespace ice_ice_baby {

namespace {

template <class Sequence>
void writeNext(const Simulation& simulation, std::optional<Sequence>& sequence) {
  if (!sequence) return;
  const auto begin = std::chrono::steady_clock::now();
  sequence->writer.write(simulation);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  sequence->written.wall_s += taken.count();
  ++sequence->written.frames;
}

}  // namespace

FrameOutputs::FrameOutputs(const SequenceFolders& folders, const Scene& scene) {
  if (!folders.frames.empty()) {
    pictures_.emplace(Sequence<FrameWriter>{{folders.frames, scene}, {"pictures", folders.frames}});
  }
  if (!folders.surface.empty()) {
    surfaces_.emplace(Sequence<SurfaceWriter>{{folders.surface, folders.surface_format, scene},
                                              {"surfaces", folders.surface}});
  }
  if (!folders.particles.empty()) {
    particles_.emplace(Sequence<ParticleWriter>{{folders.particles, folders.particles_format},
                                                {"exports of particles", folders.particles}});
  }
}

void FrameOutputs::write(const Simulation& simulation) {
  writeNext(simulation, pictures_);
  writeNext(simulation, surfaces_);
  writeNext(simulation, particles_);
}

std::vector<WrittenSequence> FrameOutputs::finish() const {
  std::vector<WrittenSequence> written;
  if (pictures_) written.push_back(pictures_->written);
  if (surfaces_) {
    surfaces_->writer.finish();
    written.push_back(surfaces_->written);
  }
  if (particles_) {
    particles_->writer.finish();
    written.push_back(particles_->written);
  }
  return written;
}

}  // namespace ice_ice_baby
