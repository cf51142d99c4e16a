// When and where water comes out of the sources of a scene.
#pragma once

#include <cstdint>
#include <vector>

#include "flow/outlet.h"
#include "flow/outlet_motion.h"

namespace ice_ice_baby {

/// A particle that is to come out.
struct Drop {
  std::size_t site;    ///< number of its site in the outlet
  bool waited;         ///< whether there was no place for it before
  Vec3d from_m;        ///< its site when the substep began
  Vec3d site_m;        ///< its site now
  Vec3d position_m;    ///< where it has got to
  Vec3d velocity_m_s;  ///< there
};

/// A source emits a layer whenever its flow has filled one. Layers that are due within a substep
/// start at the times between, so the spacing of a jet depends on neither frames nor substeps.
/// A particle for which there is no place waits at its site until the next one there has to wait.
/// Water leaves with the velocity of the flow plus that of the outlet, which turns the flow with
/// it.
class Sources {
 public:
  explicit Sources(const Scene& scene);

  std::size_t count() const { return outflows_.size(); }

  /// Motion of the outlet of source k.
  OutletMotion& motion(std::size_t k) { return outflows_[k].motion; }
  const OutletMotion& motion(std::size_t k) const { return outflows_[k].motion; }
  /// Lets outlets jump that would move farther than `max_m` in the frame.
  void beginFrame(const Scene& scene, double max_m);
  /// Sets when the next substep begins and ends. @param begin, end fractions of the frame
  void setSubstep(double begin, double end);
  /// Ends the frame: every outlet is where it was moving.
  void endFrame();

  /// Advances source k by a substep that ends now.
  /// @param room number of particles that the scene still takes; a layer that does not fit is lost
  /// @return particles that waited, at their sites, then those that are due, at their positions
  /// after free flight since they came out; valid until the next call
  const std::vector<Drop>& advance(const Scene& scene, std::size_t k, double dt_s, double room);

  /// Keeps a drop for which there is no place. @return whether it is lost, as another one waits
  bool keep(std::size_t k, const Drop& drop);

  /// Sources that are open, but have no room for their next layer.
  std::size_t stopped(const Scene& scene, double room) const;

  std::size_t bytes() const;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    for (auto& outflow : self.outflows_) archive(outflow.progress, outflow.waiting, outflow.motion);
  }
  /// @throws InvalidInput if the state of a checkpoint is out of range
  void restore() const;

 private:
  struct Outflow {
    Outlet outlet;
    double progress = 0.0;      ///< part of the next layer that has come, 0 ... 1
    std::vector<char> waiting;  ///< (sites) whether a particle waits
    OutletMotion motion;
  };

  void addWaiting(const Scene& scene, std::size_t k);
  void emit(const Scene& scene, std::size_t k, double age_s, double dt_s);

  std::vector<Outflow> outflows_;
  std::vector<Drop> drops_;         ///< result of advance
  double begin_ = 0.0, end_ = 1.0;  ///< of the substep, as fractions of the frame
};

/// Whether any source is open.
bool anyOpen(const std::vector<Source>& sources);

}  // namespace ice_ice_baby
