// Springs, the paper's model of freezing. They exert no force. They correct positions so that their
// lengths stay within a range that narrows as the temperature falls.
#pragma once

#include <vector>

#include "particles/neighbours.h"
#include "particles/particles.h"
#include "phase/phases.h"

namespace ice_ice_baby {

/// Allowed range of the length of a spring, relative to its rest length.
struct SpringRange {
  double shortest = 1.0;
  double longest = 1.0;
};

/// Allowed range at a strictness from 0 (onset) to 1 (frozen) over a substep of `dt_s`. The slack
/// is proportional to 1 - strictness. There is no maximum length: in the paper springs push their
/// ends apart and never pull them together.
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

/// Length outside the allowed range: negative if too short, positive if too long.
template <class Real>
Real springCorrection(Real length_m, Real rest_m, const SpringRange& range);

template <class Real>
class Springs {
 public:
  explicit Springs(const SpringParams& params) : params_(params) {}

  /// Adds the springs of a sheet, which never melt, between its particles up to `reach_m` apart.
  void addSheet(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
                const Spawn& sheet, Real reach_m);

  /// Joins every particle to its neighbours up to `reach_m` apart. The rest length is the distance
  /// between the positions x_i.
  /// @param phases what belongs to solids, which are not joined; null: nothing does
  void make(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
            const Phases<Real>* phases, Real reach_m);

  /// Makes the springs rigid from now on, with their present rest lengths.
  void keep() { kept_ = true; }
  bool kept() const { return kept_; }

  /// Removes the springs that make() added.
  void melt();

  /// Joins every particle that has just frozen to ice up to `reach_m` away, with the present
  /// distance as rest length.
  /// @param apart spawns that are not joined to each other; null: all ice joins
  void freeze(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
              const Phases<Real>& phases, Real reach_m, const std::vector<Spawn>* apart = nullptr);

  /// Joins particles that came to springs that are kept, as `make` would have.
  /// @param phases as for make
  /// @param first_id of those that came
  void joinNew(const Particles<Real>& particles, const Neighbours<Real>& neighbours,
               const Phases<Real>* phases, Real reach_m, std::uint32_t first_id);

  /// Removes every spring, those of sheets too, of particles that are about to go.
  /// @param gone (n) whether a particle goes
  void removeOf(const std::vector<char>& gone);

  /// Removes springs with an end that is no longer ice; those of sheets stay.
  void breakMelted(const Phases<Real>& phases);

  /// Labels connected ice: particles joined by a chain of springs have the same label, the smallest
  /// of their indices. kNone for particles without springs.
  void labelBodies(const Phases<Real>& phases, std::vector<Index>& labels) const;

  /// Corrects x* along each spring in turn, half to each end (Algorithm 1).
  /// @param begins whether this is the first iteration of a substep
  void correct(VectorField<Real>& predicted, double strictness, double particle_kg, double dt_s,
               bool begins);

  /// The same for elastic ice: a spring stretched by c pulls with c / compliance newtons (XPBD,
  /// Macklin et al. 2016), independent of the number of iterations and substeps.
  /// @param begins whether this is the first iteration of a substep
  void correctElastic(VectorField<Real>& predicted, double compliance_m_n, double particle_kg,
                      double dt_s, bool begins);

  /// Removes springs of ice that are stretched by more than `strain` times their rest length.
  void breakStretched(const VectorField<Real>& position, double strain);

  /// Follows a sort of the particles: place k now holds what was at order[k]. What is not in it
  /// has no springs.
  void renumber(const std::vector<Index>& order);

  /// Energy stored in stretched springs, J. A spring whose multiplier summed to L in a substep
  /// pulls with a force L / dt^2 over its remaining stretch.
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
  std::vector<Spring<Real>> springs_;  ///< springs of sheets come first
  std::size_t sheet_count_ = 0;
  bool kept_ = false;
  std::vector<Real> multipliers_;  ///< (lasting springs) kg m, of the present substep
  std::vector<Index> place_of_;    ///< scratch of renumber
};

}  // namespace ice_ice_baby
