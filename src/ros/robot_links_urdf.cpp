#include <fnmatch.h>
#include <urdf/model.h>

#include "ice_ice_baby/errors.h"
#include "robot_links.h"

namespace ice_ice_baby {

namespace {

Vec3d vectorOf(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

/// A collider of a link with its place in the frame of the link.
template <class Shape>
Shape& addTo(std::vector<Shape>& list, const std::string& name, const urdf::Collision& collision,
             const std::string& frame) {
  Shape& shape = list.emplace_back();
  shape.name = name;
  shape.follow_frame = frame;
  shape.position_m = vectorOf(collision.origin.position);
  Vec3d rpy;
  collision.origin.rotation.getRPY(rpy.x(), rpy.y(), rpy.z());
  shape.rpy_deg = rpy * 180 / M_PI;
  return shape;
}

void setScale(const Vec3d& scale, Mesh& mesh) {
  mesh.scale = scale.cwiseAbs().maxCoeff();
  if (mesh.scale > 0) mesh.stretch = scale / mesh.scale;
}

std::string fileOf(const urdf::Mesh& mesh) {
  const std::string scheme = "file://";
  return mesh.filename.rfind(scheme, 0) == 0 ? mesh.filename.substr(scheme.size()) : mesh.filename;
}

void addCollision(Scene& scene, const std::string& name, const urdf::Collision& collision,
                  const std::string& frame) {
  const urdf::Geometry& geometry = *collision.geometry;
  if (geometry.type == urdf::Geometry::BOX) {
    addTo(scene.boxes, name, collision, frame).size_m =
        vectorOf(static_cast<const urdf::Box&>(geometry).dim);
  } else if (geometry.type == urdf::Geometry::SPHERE) {
    addTo(scene.spheres, name, collision, frame).radius_m =
        static_cast<const urdf::Sphere&>(geometry).radius;
  } else if (geometry.type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
    Cylinder& added = addTo(scene.cylinders, name, collision, frame);
    added.radius_m = cylinder.radius;
    added.height_m = cylinder.length;
  } else {
    const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
    Mesh& added = addTo(scene.meshes, name, collision, frame);
    added.file = fileOf(mesh);
    setScale(vectorOf(mesh.scale), added);
  }
}

void addLink(Scene& scene, const urdf::Link& link) {
  std::size_t number = 0;
  for (const auto& collision : link.collision_array) {
    if (!collision || !collision->geometry) continue;
    ++number;
    const std::string name = number == 1 ? link.name : link.name + "_" + std::to_string(number);
    addCollision(scene, name, *collision, link.name);
  }
  if (number == 0) {
    throw InvalidInput("link " + link.name +
                       " has no collision geometry; add <collision> to it in robot_description, or "
                       "leave it out of ~links");
  }
}

}  // namespace

void addRobotLinks(Scene& scene, const std::string& description,
                   const std::vector<std::string>& patterns) {
  if (description.empty()) {
    throw InvalidInput("parameter ~links needs the parameter robot_description, which is not set");
  }
  urdf::Model model;
  if (!model.initString(description)) {
    throw InvalidInput("robot_description is no URDF; see the messages above");
  }
  for (const std::string& pattern : patterns) {
    std::size_t matching = 0;
    std::vector<std::string> names;
    for (const auto& [name, link] : model.links_) {
      names.push_back(name);
      if (fnmatch(pattern.c_str(), name.c_str(), 0) != 0) continue;
      ++matching;
      addLink(scene, *link);
    }
    if (matching == 0) {
      throw InvalidInput("parameter ~links: no link of robot_description matches " +
                         shortened(pattern) + "; it has: " + joined(names));
    }
  }
}

}  // namespace ice_ice_baby
