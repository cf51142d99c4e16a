// Springs: the paper's freezing. They exert no force; they correct positions so that the distance
// between their ends stays within a range that tightens as the temperature falls.
#pragma once

#include <vector>

#include "particles/neighbours.h"
#include "particles/particles.h"
#include "phase/phases.h"

namespace ice_ice_baby {

/// Range that springs allow around their rest length, as factors of it.
struct SpringRange {
  double shortest = 1.0;
  double longest = 1.0;
};

/// Range that freezing springs allow at a strictness from 0 (onset) to 1 (frozen) over a substep of
/// `dt_s`: the slack shrinks in proportion to 1 - strictness. There is no longest length: the paper
/// manipulates the minimum so that springs push ends apart and never pull them together.
SpringRange allowedRange(const SpringParams& params, double strictness, double dt_s);

template <class Real>
struct Spring {
  Index a;
  Index b;
  Real rest_m;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.a, self.b, self.rest_m);
  }
};

/// Length error of a spring outside its range: negative when too short, positive when too long.
template <class Real>
Real springCorrection(Real length_m, Real rest_m, const SpringRange& range);

template <class Real>
class Springs {
 public:
  explicit Springs(const SpringParams& params) : params_(params) {}

  /// Springs of a sheet, which never melt: between particles of one spawn up to `reach_m`.
  void addSheet(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                const Spawn& sheet, Real reach_m);

  /// Joins every particle to its neighbours up to `reach_m`; the rest length is the distance at
  /// x_i.
  void make(const Particles<Real>& particles, const Neighbours<Real>& neighbours, Real reach_m);

  /// From now on the springs are rigid: they keep their rest lengths and allow no other.
  void keep() { kept_ = true; }
  bool kept() const { return kept_; }

  /// Removes what make() made.
  void melt();

  /// Joins every particle that has just frozen to the ice up to `reach_m` around it, at rest as it
  /// lies now.
  /// @param apart spawns that are not joined to each other; null: all ice joins
  void freeze(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
              const Phases<Real>& phases, Real reach_m, const std::vector<Spawn>* apart = nullptr);

  /// Joins particles that came to springs that are kept, as `make` would have.
  /// @param first_id of those that came
  void joinNew(const Particles<Real>& particles, const Neighbours<Real>& neighbours, Real reach_m,
               std::uint32_t first_id);

  /// Removes every spring, those of sheets too, of particles that are about to go.
  /// @param gone (n) whether a particle goes
  void removeOf(const std::vector<char>& gone);

  /// Removes the springs that have an end in what is no ice any more; those of sheets stay.
  void breakMelted(const Phases<Real>& phases);

  /// Numbers the bodies that ice makes: particles that a chain of springs joins carry the same
  /// label, the least of their places, kNone those of what belongs to none.
  void labelBodies(const Phases<Real>& phases, std::vector<Index>& labels) const;

  /// Corrects x* along each spring in turn, half to each end (Algorithm 1).
  /// @param begins whether this is the first iteration of a substep
  void correct(VectorField<Real>& predicted, double strictness, double particle_kg, double dt_s,
               bool begins);

  /// The same for elastic ice: a spring stretched by c pulls with c / compliance newtons (XPBD,
  /// Macklin et al. 2016), however many iterations and substeps there are.
  /// @param begins whether this is the first iteration of a substep
  void correctElastic(VectorField<Real>& predicted, double compliance_m_n, double particle_kg,
                      double dt_s, bool begins);

  /// Removes the springs of ice that are stretched by more than `strain` of their rest length.
  void breakStretched(const VectorField<Real>& position, double strain);

  /// Follows a sort of the particles: place k now holds what was at order[k]. What is not in it
  /// has no springs.
  void renumber(const std::vector<Index>& order);

  /// What stretched springs give back, J: a spring that a substep corrected by a multiplier L in
  /// all pulls with L / dt^2, and does so over the stretch that is left.
  double elasticEnergy_j(const VectorField<Real>& position, double dt_s) const;

  bool empty() const { return springs_.empty(); }
  std::size_t size() const { return springs_.size(); }
  std::size_t bytes() const;
  const std::vector<Spring<Real>>& all() const { return springs_; }

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.springs_, self.sheet_count_, self.kept_);
  }
  /// @throws InvalidInput when what was read joins other than `particles` particles
  void restore(std::size_t particles) const;

 private:
  template <class Joined>
  void join(const Particles<Real>& particles, const Neighbours<Real>& neighbours, Real reach_m,
            const Joined& joined);
  template <class Broken>
  void breakFrom(std::size_t first, const Broken& broken);

  SpringParams params_;
  std::vector<Spring<Real>> springs_;  ///< those of sheets first
  std::size_t sheet_count_ = 0;
  bool kept_ = false;
  std::vector<Real> multipliers_;  ///< (those that last) kg m, of a substep
  std::vector<Index> place_of_;    ///< scratch of renumber
};

}  // namespace ice_ice_baby
