#include "colliders/mesh_shape.h"

#include "ice_ice_baby/errors.h"
#include "meshes/mesh_curvature.h"
#include "meshes/mesh_edges.h"
#include "meshes/mesh_topology.h"
#include "meshes/solids_of_revolution.h"
#include "meshes/surface_contact.h"

namespace ice_ice_baby {

namespace {

/// @param what the collider and its measures, for messages
template <class Real>
MeshShape<Real> shapeOf(TriangleMesh mesh, double radius_m, const std::string& what) {
  MeshShape<Real> shape;
  shape.radius = static_cast<Real>(radius_m);
  try {
    shape.triangles = Surface::shared(std::move(mesh), radius_m);
  } catch (const InvalidInput& e) {
    throw InvalidInput(what + ": " + e.what());
  }
  return shape;
}

std::string measureText(const char* key, double value) {
  return std::string(key) + " = " + numberText(value);
}

/// For scenes built in code: those of files have been checked when they were read.
void requireSound(const Mesh& m) {
  if (!m.triangles) {
    throw InvalidInput("mesh " + m.name +
                       " has no triangles; scenes read from a file read them from `file`, scenes "
                       "built in code set `triangles`");
  }
  const std::vector<Vec3d>& vertices = m.triangles->vertices;
  for (const Vec3d& vertex : vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      requireInRange("a vertex of mesh " + m.name, vertex[axis], -kMaxCoordinate_m,
                     kMaxCoordinate_m);
    }
  }
  for (const auto& corners : m.triangles->triangles) {
    for (const Index corner : corners) {
      if (corner < vertices.size()) continue;
      throw InvalidInput("a triangle of mesh " + m.name + " has corner " + std::to_string(corner) +
                         " of " + std::to_string(vertices.size()));
    }
  }
}

/// Adds the edges of a single triangle and those at which the surface turns sharply.
void addSharpEdges(const Surface& surface, ColliderMesh& mesh) {
  const double smooth = std::cos(kSharpEdge_deg * M_PI / 180);
  const auto normal = [&](Index k) { return surface.tree().triangle(k).normal().normalized(); };
  forEachEdge(edgeSidesOf(surface.mesh()), [&](const EdgeSide* first, const EdgeSide* last) {
    const bool between_two = last - first == 2;
    if (between_two && normal(first[0].triangle).dot(normal(first[1].triangle)) > smooth) return;
    mesh.edges.push_back({first->low, first->high});
  });
}

}  // namespace

template <class Real>
MeshShape<Real> makeShape(const Cylinder& c, double radius_m) {
  return shapeOf<Real>(cylinderMesh(c.radius_m, c.height_m), radius_m,
                       "cylinder " + c.name + " with " + measureText("radius_m", c.radius_m) +
                           " and " + measureText("height_m", c.height_m));
}

template <class Real>
MeshShape<Real> makeShape(const Capsule& c, double radius_m) {
  return shapeOf<Real>(capsuleMesh(c.radius_m, c.length_m), radius_m,
                       "capsule " + c.name + " with " + measureText("radius_m", c.radius_m) +
                           " and " + measureText("length_m", c.length_m));
}

template <class Real>
MeshShape<Real> makeShape(const Cup& c, double radius_m) {
  MeshShape<Real> shape = shapeOf<Real>(
      cupMesh(c.radius_m, c.depth_m, c.wall_m), radius_m,
      "cup " + c.name + " with " + measureText("radius_m", c.radius_m) + ", " +
          measureText("depth_m", c.depth_m) + " and " + measureText("wall_m", c.wall_m));
  shape.look = Look::kGlass;
  shape.vessel = true;
  return shape;
}

template <class Real>
MeshShape<Real> makeShape(const Mesh& m, double radius_m) {
  requireSound(m);
  TriangleMesh triangles = welded(*m.triangles);
  if (triangles.triangles.empty()) {
    throw InvalidInput("mesh " + m.name + " has no triangle with an area");
  }
  MeshShape<Real> shape = shapeOf<Real>(
      std::move(triangles), radius_m, "mesh " + m.name + " with " + measureText("scale", m.scale));
  shape.look = m.opacity < 1.0 ? Look::kGlass : Look::kObject;
  shape.vessel = true;
  return shape;
}

template <class Real>
Vec3<Real> MeshShape<Real>::resolve(const Vec3<Real>& from, const Vec3<Real>& to) const {
  const Vec3d wanted = to.template cast<double>();
  if (from == to && triangles->encloses(wanted)) return outside(wanted).template cast<Real>();
  const Vec3d end = endBeside(*triangles, from.template cast<double>(), wanted);
  return end == wanted ? to : end.template cast<Real>();
}

/// The nearest place outside, for a point in the solid that has not moved there.
template <class Real>
Vec3d MeshShape<Real>::outside(const Vec3d& point) const {
  const SurfacePoint closest = triangles->closest(point, std::numeric_limits<double>::infinity());
  const Vec3d outwards = triangles->tree().triangle(closest.triangle).normal().normalized();
  const double side = triangles->topology().volume_m3 < 0 ? -1.0 : 1.0;
  const Vec3d surface = closest.point + side * 1e-3 * double(this->radius) * outwards;
  return endBeside(*triangles, surface, closest.point + side * double(this->radius) * outwards);
}

template <class Real>
NearSurfaces<Real> MeshShape<Real>::near(const Vec3<Real>& point, Real reach_m) const {
  NearSurfaces<Real> surfaces;
  if (triangles->atLeast(point) >= reach_m) return surfaces;
  const Vec3d x = point.template cast<double>();
  const SurfacePoint closest = triangles->closest(x, double(reach_m));
  if (!closest.found() || closest.distance_m == 0.0) return surfaces;
  const Vec3d normal = (x - closest.point) / closest.distance_m;
  const auto distance = static_cast<Real>(closest.distance_m);
  surfaces.add({distance - this->radius, distance, normal.cast<Real>(),
                static_cast<Real>(triangles->flatness(closest, x)), 0,
                (closest.point + double(this->radius) * normal).cast<Real>()});
  return surfaces;
}

template <class Real>
void MeshShape<Real>::faces(const PushedPath& path, FaceCollector& faces) const {
  const Vec3d end = path.to + path.push;
  const SurfacePoint closest = triangles->closest(end, std::numeric_limits<double>::infinity());
  if (closest.distance_m == 0.0) return;
  const Vec3d normal = (end - closest.point) / closest.distance_m;
  faces.add(normal, normal.dot(closest.point) + double(this->radius));
}

template <class Real>
ColliderMesh MeshShape<Real>::mesh(const MeshDetail&) const {
  ColliderMesh mesh;
  mesh.look = look;
  mesh.vertices = triangles->mesh().vertices;
  mesh.triangles = triangles->mesh().triangles;
  if (look == Look::kGlass) addSharpEdges(*triangles, mesh);
  return mesh;
}

template struct MeshShape<float>;
template struct MeshShape<double>;
template MeshShape<float> makeShape<float>(const Cylinder&, double);
template MeshShape<double> makeShape<double>(const Cylinder&, double);
template MeshShape<float> makeShape<float>(const Capsule&, double);
template MeshShape<double> makeShape<double>(const Capsule&, double);
template MeshShape<float> makeShape<float>(const Cup&, double);
template MeshShape<double> makeShape<double>(const Cup&, double);
template MeshShape<float> makeShape<float>(const Mesh&, double);
template MeshShape<double> makeShape<double>(const Mesh&, double);

}  // namespace ice_ice_baby
