// Colliders of a scene as plain data, and their keys, as in params.h. CONTRIBUTING.md describes how
// to add a shape.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ice_ice_baby/params.h"
#include "ice_ice_baby/triangle_mesh.h"

namespace ice_ice_baby {

/// Pose with the rotation Rz(yaw) Ry(pitch) Rx(roll), as in REP 103.
Posed poseOf(const Vec3d& position_m, const Vec3d& rpy_deg);

/// Common members of all colliders.
struct Collider {
  std::string name;
  Vec3d position_m = Vec3d::Zero();
  Vec3d rpy_deg = Vec3d::Zero();
  double friction = 0.05;
  double opacity = 0.2;
  std::string follow_frame;
  ThermalBoundary heat = ThermalBoundary::kInsulated;
  double celsius = 20.0;   ///< surface temperature, if heat is kTemperature
  double flux_w_m2 = 0.0;  ///< into the water, if heat is kFlux

  /// Pose in the scene frame.
  Posed pose() const { return poseOf(position_m, rpy_deg); }
};

template <class Visitor>
void describeCollider(Collider& c, Visitor&& visit) {
  visit("name", c.name, "name used by services and tf");
  visit("position_m", c.position_m, kCoordinateRange_m,
        "position of the centre; container, cup: centre of the inner floor; plane: centre of the "
        "top; mesh: origin of the file");
  visit("rpy_deg", c.rpy_deg, Range{-360.0, 360.0},
        "roll, pitch, yaw about the fixed axes x, y, z");
  visit("friction", c.friction, Range{0.0, 10.0}, "Coulomb friction coefficient; 0: frictionless");
  visit("opacity", c.opacity, Range{0.0, 1.0}, "opacity in pictures and markers; 0: invisible");
  visit("follow_frame", c.follow_frame, "tf frame that the collider follows; \"\": none");
  visit("heat", c.heat,
        "thermal boundary condition of its surface, with thermal.enabled: none, fixed temperature "
        "or fixed flux");
  visit("celsius", c.celsius, kTemperatureRange_c,
        "temperature of the surface, if heat is temperature");
  visit("flux_w_m2", c.flux_w_m2, Range{-1e7, 1e7},
        "flux into the water, if heat is flux; below 0: cooling");
}

/// Box that holds water: `position_m` is the centre of its inner floor, `size_m` its inner size.
struct Container : Collider {
  Vec3d size_m = Vec3d::Ones();
  double wall_m = 0.02;
  bool open_top = true;
};

template <class Visitor>
void describe(Container& c, Visitor&& visit) {
  describeCollider(c, visit);
  visit("size_m", c.size_m, Range{1e-3, 2 * kMaxCoordinate_m}, "inner size");
  visit("wall_m", c.wall_m, Range{1e-4, 10.0}, "thickness of walls and floor");
  visit("open_top", c.open_top, "whether the top is open");
}

/// Ground: everything below the local z = 0. With a size, a plate of that size and thickness.
struct Plane : Collider {
  double size_x_m = 0.0;
  double size_y_m = 0.0;
  double thickness_m = 0.1;

  bool infinite() const { return size_x_m == 0.0 || size_y_m == 0.0; }
};

template <class Visitor>
void describe(Plane& p, Visitor&& visit) {
  describeCollider(p, visit);
  visit("size_x_m", p.size_x_m, Range{0.0, 2 * kMaxCoordinate_m}, "0: infinite");
  visit("size_y_m", p.size_y_m, Range{0.0, 2 * kMaxCoordinate_m}, "0: infinite");
  visit("thickness_m", p.thickness_m, Range{1e-4, 10.0}, "thickness of a finite plate");
}

struct Sphere : Collider {
  double radius_m = 0.1;
};

template <class Visitor>
void describe(Sphere& s, Visitor&& visit) {
  describeCollider(s, visit);
  visit("radius_m", s.radius_m, Range{1e-3, kMaxCoordinate_m}, "radius");
}

/// Solid box: `position_m` is its centre.
struct Box : Collider {
  Vec3d size_m = Vec3d::Constant(0.1);
};

template <class Visitor>
void describe(Box& b, Visitor&& visit) {
  describeCollider(b, visit);
  visit("size_m", b.size_m, Range{1e-3, 2 * kMaxCoordinate_m}, "length of its sides");
}

/// Solid cylinder around the local z; `position_m` is its middle.
struct Cylinder : Collider {
  double radius_m = 0.1;
  double height_m = 0.2;
};

template <class Visitor>
void describe(Cylinder& c, Visitor&& visit) {
  describeCollider(c, visit);
  visit("radius_m", c.radius_m, Range{1e-3, kMaxCoordinate_m}, "radius");
  visit("height_m", c.height_m, Range{1e-3, 2 * kMaxCoordinate_m}, "height along the local z");
}

/// Solid cylinder around the local z with a half ball at each end; `position_m` is its middle.
struct Capsule : Collider {
  double radius_m = 0.1;
  double length_m = 0.2;
};

template <class Visitor>
void describe(Capsule& c, Visitor&& visit) {
  describeCollider(c, visit);
  visit("radius_m", c.radius_m, Range{1e-3, kMaxCoordinate_m}, "radius");
  visit("length_m", c.length_m, Range{1e-3, 2 * kMaxCoordinate_m},
        "length along the local z, without the half balls");
}

/// Round open container; `position_m` is the middle of its inner floor.
struct Cup : Collider {
  double radius_m = 0.04;
  double depth_m = 0.1;
  double wall_m = 0.004;
};

template <class Visitor>
void describe(Cup& c, Visitor&& visit) {
  describeCollider(c, visit);
  visit("radius_m", c.radius_m, Range{1e-3, kMaxCoordinate_m}, "inner radius");
  visit("depth_m", c.depth_m, Range{1e-3, 2 * kMaxCoordinate_m}, "from the floor to the rim");
  visit("wall_m", c.wall_m, Range{1e-4, 10.0}, "thickness of wall and floor");
}

/// Surface of triangles with two sides: a solid if it is closed, else thin walls.
struct Mesh : Collider {
  std::string file;
  double scale = 1.0;
  Vec3d stretch = Vec3d::Ones();
  /// In the frame of the collider, scaled. Read from `file` by loadScene; set it in code.
  std::shared_ptr<const TriangleMesh> triangles;
};

template <class Visitor>
void describe(Mesh& m, Visitor&& visit) {
  describeCollider(m, visit);
  visit("file", m.file,
        "STL, OBJ, DAE or PLY; a path relative to the scene file, or package://PACKAGE/PATH");
  visit("scale", m.scale, Range{1e-6, 1e6}, "metres per unit of the file; 0.001: millimetres");
  visit("stretch", m.stretch, Range{-1000.0, 1000.0},
        "further factor along each axis of the file; a negative one mirrors the mesh");
}

/// The colliders of a scene, one list for each shape.
struct ColliderLists {
  std::vector<Container> containers;
  std::vector<Plane> planes;
  std::vector<Sphere> spheres;
  std::vector<Box> boxes;
  std::vector<Cylinder> cylinders;
  std::vector<Capsule> capsules;
  std::vector<Cup> cups;
  std::vector<Mesh> meshes;
};

/// Texts about a list of colliders.
struct ColliderKind {
  const char* key;      ///< key of the list in a scene file
  const char* noun;     ///< one of them, in messages and default names
  const char* meaning;  ///< text for config/default.yaml
};

/// Calls visit(list, kind) for every list of colliders. This order determines the indices of
/// colliders. Later lists are resolved first in contact.
template <class Lists, class Visit>
void forEachColliderList(Lists& lists, const Visit& visit) {
  visit(lists.containers, ColliderKind{"containers", "container", "boxes that hold water"});
  visit(lists.planes, ColliderKind{"planes", "plane", "grounds and plates"});
  visit(lists.spheres, ColliderKind{"spheres", "sphere", "spheres"});
  visit(lists.boxes, ColliderKind{"boxes", "box", "solid boxes"});
  visit(lists.cylinders, ColliderKind{"cylinders", "cylinder", "solid cylinders"});
  visit(lists.capsules, ColliderKind{"capsules", "capsule", "cylinders with round ends"});
  visit(lists.cups, ColliderKind{"cups", "cup", "round containers without a lid"});
  visit(lists.meshes, ColliderKind{"meshes", "mesh", "surfaces of triangles from files"});
}

}  // namespace ice_ice_baby
