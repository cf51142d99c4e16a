#include "surface_file.h"

#include <cstdio>
#include <initializer_list>

#include "base/written_file.h"

namespace ice_ice_baby {

namespace {

/// What PLY and the processors that this runs on agree on.
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "PLY files are written as little endian");

template <class Value>
void append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append(std::string& bytes, const Vec3<float>& vector) {
  for (int axis = 0; axis < 3; ++axis) append(bytes, vector[axis]);
}

void addProperties(std::string& header, const char* type,
                   std::initializer_list<const char*> names) {
  for (const char* name : names) header += std::string("property ") + type + " " + name + "\n";
}

}  // namespace

void writePly(const std::string& path, const FluidSurface& surface) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment metres, degrees Celsius\n";
  bytes += "element vertex " + std::to_string(surface.vertices.size()) + "\n";
  const bool values = !surface.temperatures_c.empty();
  const bool colours = !surface.colours.empty();
  addProperties(bytes, "float", {"x", "y", "z", "nx", "ny", "nz"});
  if (values) addProperties(bytes, "float", {"vx", "vy", "vz", "temperature", "ice"});
  if (colours) addProperties(bytes, "uchar", {"red", "green", "blue"});
  bytes += "element face " + std::to_string(surface.triangles.size()) + "\n";
  bytes += "property list uchar int vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    append(bytes, surface.vertices[v]);
    append(bytes, surface.normals[v]);
    if (values) {
      append(bytes, surface.velocities[v]);
      append(bytes, surface.temperatures_c[v]);
      append(bytes, surface.ice_fractions[v]);
    }
    if (!colours) continue;
    for (const int shift : {16, 8, 0}) append(bytes, std::uint8_t(surface.colours[v] >> shift));
  }
  for (const auto& corners : surface.triangles) {
    append(bytes, std::uint8_t(3));
    for (const Index corner : corners) append(bytes, std::int32_t(corner));
  }
  writeFile(path, bytes);
}

void writeObj(const std::string& path, const FluidSurface& surface) {
  std::string text = "# metres\n";
  char line[128];
  const auto add = [&](const char* what, const Vec3<float>& v) {
    std::snprintf(line, sizeof line, "%s %.6g %.6g %.6g\n", what, double(v.x()), double(v.y()),
                  double(v.z()));
    text += line;
  };
  for (const Vec3<float>& vertex : surface.vertices) add("v", vertex);
  for (const Vec3<float>& normal : surface.normals) add("vn", normal);
  for (const auto& t : surface.triangles) {
    std::snprintf(line, sizeof line, "f %u//%u %u//%u %u//%u\n", t[0] + 1, t[0] + 1, t[1] + 1,
                  t[1] + 1, t[2] + 1, t[2] + 1);
    text += line;
  }
  writeFile(path, text);
}

}  // namespace ice_ice_baby
