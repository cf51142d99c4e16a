// Contacts of ice bodies and floating solids with colliders and with each other: non-penetration
// and Coulomb friction by projected Gauss-Seidel on positions (XPBD without compliance, Mueller et
// al. 2020, "Detailed rigid body simulation with extended position based dynamics"), no
// restitution.
#pragma once

#include <cstdint>
#include <vector>

#include "colliders/collider_faces.h"
#include "ice/ice_bodies.h"

namespace ice_ice_baby {

template <class Real>
class IceContacts {
 public:
  explicit IceContacts(const Scene& scene);

  /// Finds the contacts of a substep. Call it after predict and after the neighbour search. Wakes
  /// sleeping bodies that a moving body or collider touches.
  void find(IceBodies<Real>& bodies, const VectorField<Real>& predicted,
            const Neighbours<Real>& neighbours, const Colliders<Real>& colliders);

  /// Moves bodies until no contact is violated, with friction where they slide, and adds the
  /// impulses to their momenta. Multipliers start from those of the latest substep. Writes the
  /// predicted positions of all members whose bodies are neither asleep nor anchored.
  void solve(IceBodies<Real>& bodies, VectorField<Real>& predicted);

  /// Ends the substep: a body that is still deep inside a collider, or not finite, returns to its
  /// pose at the start of the substep and loses its momenta. Writes its members.
  void contain(IceBodies<Real>& bodies, VectorField<Real>& predicted);

  /// Moves free bodies out of colliders that they overlap, without changing their momenta. Call it
  /// between two substeps.
  void expel(IceBodies<Real>& bodies, const Colliders<Real>& colliders);

  /// Takes over the numbers that members have since bodies changed, as `find` does by itself. To be
  /// called between two changes without a substep.
  void followMembers(const IceBodies<Real>& bodies);

  /// Calls visit(collider, point, impulse in kg m/s on the ice) for every contact with a collider
  /// in the latest substep.
  template <class Visit>
  void forEachWallImpulse(const Visit& visit) const {
    for (const auto* contacts : {&walls_, &dormant_walls_}) {
      for (const Contact& contact : *contacts) {
        const Vec3d multiplier =
            contact.normal_multiplier * contact.normal + contact.friction_multiplier;
        visit(contact.collider, contact.point, Vec3d(multiplier / dt_s_));
      }
    }
  }

  /// Contacts of the present substep.
  std::size_t count() const { return walls_.size() + pairs_.size(); }
  /// How many bodies `contain` has moved back so far.
  std::uint64_t limited() const { return limited_; }
  std::size_t bytes() const;

  template <class Self, class Archive>
  static void exchange(Self& self, Archive& archive) {
    archive(self.walls_, self.pairs_, self.dormant_walls_, self.dormant_pairs_, self.candidates_,
            self.generation_, self.builds_, self.dt_s_);
  }
  /// @throws InvalidInput when what was read touches other than these bodies
  void restore(const IceBodies<Real>& bodies) const;

 private:
  /// A member at a face of a collider, or two members of different bodies.
  struct Contact {
    std::uint64_t key;  ///< ascending in each list; identifies a contact across substeps
    Index a, b;         ///< bodies; b: kNone for a collider
    Index member_a, member_b;
    Index collider;
    Vec3d normal;     ///< towards a
    Vec3d point;      ///< of the face, for a collider
    double gap_m;     ///< at detection
    double before_m;  ///< at the start of the substep
    double friction;
    double normal_multiplier = 0;               ///< kg m: force times dt^2
    Vec3d friction_multiplier = Vec3d::Zero();  ///< kg m, along the face
    bool swept = false;  ///< whether the members met on their way; uses arm_a, arm_b
    double met = 1.0;    ///< fraction of the substep at which they touch
    Vec3d arm_a = Vec3d::Zero(), arm_b = Vec3d::Zero();  ///< from the centres, m, if swept

    /// State that the next substep starts from.
    template <class Self, class Archive>
    static void exchange(Self& self, Archive& archive) {
      archive(self.key, self.a, self.b, self.member_a, self.member_b, self.normal_multiplier,
              self.friction_multiplier, self.swept);
    }
  };
  /// A constraint along one axis of a contact, linear in the moves of its bodies.
  struct Row {
    Vec3d axis;
    Vec3d lever_a, lever_b;        ///< arm x axis
    Vec3d rotation_a, rotation_b;  ///< rotation of a unit multiplier
    double inverse_mass;           ///< generalised, 1/kg
    double value_m;                ///< at no move
  };
  struct Rows {
    Row normal, first, second;
    double mass_a, mass_b;  ///< inverse mass, 1/kg; 0 if immovable
    Index a, b;             ///< bodies
    Vec3d given;            ///< multipliers already added to the momenta
  };
  /// Displacement and rotation of a body since the rows were set up.
  struct Move {
    Vec3d by = Vec3d::Zero();
    Vec3d rotation = Vec3d::Zero();
    Mat3<double> back = Mat3<double>::Identity();  ///< rotation from `next` to `pose`
    bool touched = false;
  };
  /// Members of different bodies that may touch while the neighbour lists are valid.
  struct Candidate {
    Index a, b;  ///< members, a < b

    template <class Self, class Archive>
    static void exchange(Self& self, Archive& archive) {
      archive(self.a, self.b);
    }
  };

  Contact& contactAt(std::size_t k) {
    return k < walls_.size() ? walls_[k] : pairs_[k - walls_.size()];
  }

  double frictionBetween(const IceBody& a, const IceBody& b) const;
  void findWalls(const IceBodies<Real>& bodies);
  void wakeByColliders(IceBodies<Real>& bodies);
  void wakeByBodies(IceBodies<Real>& bodies);
  void findCandidates(const IceBodies<Real>& bodies, const VectorField<Real>& predicted,
                      const Neighbours<Real>& neighbours);
  void findSwept(IceBodies<Real>& bodies);
  void sweepPair(IceBodies<Real>& bodies, Index a, Index b);
  void addSwept();
  void addPair(const IceBodies<Real>& bodies, const Candidate& candidate);
  Vec3d normalBetween(const Vec3d& bare_a, const Vec3d& bare_b, const Vec3d& now,
                      const Vec3d& before) const;
  void layDown(const IceBodies<Real>& bodies, const std::vector<Contact>& before,
               std::vector<Contact>& dormant);
  void startWarm(std::vector<Contact>& contacts, const std::vector<Contact>& before, double ratio);
  void keepSupports(const IceBodies<Real>& bodies, std::vector<Contact>& contacts);
  bool keepFace(const IceBodies<Real>& bodies, const std::vector<Contact>& contacts,
                std::size_t first, std::size_t last);
  void makeRows(const IceBodies<Real>& bodies, const Contact& contact, Rows& rows) const;
  void apply(const Rows& rows, const Row& row, double multiplier);
  double violation(const Rows& rows, const Row& row) const;
  double relax(const Rows& rows, Contact& contact);
  void beginMoves(const IceBodies<Real>& bodies);
  void applyWarm(const Rows& rows, Contact& contact);
  void noteLoads(IceBodies<Real>& bodies);
  void boundEnergy(const IceBodies<Real>& bodies);
  void levelMomenta(IceBodies<Real>& bodies);
  double movedSinceFound(const IceBody& body, Index b) const;
  bool deepInside(const IceBodies<Real>& bodies, const Contact& contact) const;
  void markOut(Index b, Index collider);
  void checkAll(const IceBodies<Real>& bodies, Index b);
  Vec3d longestPush(const IceBodies<Real>& bodies, Index b) const;
  void putBack(IceBodies<Real>& bodies, Index b);

  double spacing_m_;
  double contact_m_;                    ///< contact distance between members of two bodies
  double friction_;                     ///< of ice on ice
  std::vector<double> solid_friction_;  ///< of the solids of the scene
  double margin_m_;  ///< pairs closer than this count as contacts before they touch
  ColliderFaces faces_;
  std::vector<Contact> walls_, pairs_;
  std::vector<Contact> old_walls_, old_pairs_;
  std::vector<Contact> swept_;  ///< bodies that would pass through each other in this substep
  std::vector<Contact> dormant_walls_, dormant_pairs_;  ///< contacts of sleeping bodies
  std::vector<Rows> rows_;
  std::vector<Move> moves_;       ///< (bodies)
  std::vector<Placement> found_;  ///< (bodies) `next` when contacts were found
  std::vector<Candidate> candidates_;
  std::vector<Index> near_;  ///< colliders near a body
  enum Stay : char { kOpen, kStays, kDropped };
  std::vector<char> stays_;        ///< a Stay for each contact of one body
  std::vector<std::size_t> face_;  ///< contacts of one face
  std::vector<Vec3d> plane_;       ///< coordinates along and across the face, and the gap, m
  std::vector<char> out_;          ///< (bodies) whether contain must move it back
  std::vector<Index> carrier_;     ///< (bodies) collider that carries it in that case
  std::size_t generation_ = 0;
  std::size_t builds_ = 0;
  double dt_s_ = 0;
  bool warm_ = false;
  std::uint64_t limited_ = 0;
};

}  // namespace ice_ice_baby
