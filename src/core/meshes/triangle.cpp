#include "meshes/triangle.h"

#include <cmath>

namespace ice_ice_baby {

TrianglePoint closestPoint(const Triangle& t, const Vec3d& x) {
  const Vec3d ab = t.b - t.a, ac = t.c - t.a, ax = x - t.a;
  const double d1 = ab.dot(ax), d2 = ac.dot(ax);
  if (d1 <= 0 && d2 <= 0) return {t.a, TrianglePart::kCorner, Vec3d::Zero()};
  const Vec3d bx = x - t.b;
  const double d3 = ab.dot(bx), d4 = ac.dot(bx);
  if (d3 >= 0 && d4 <= d3) return {t.b, TrianglePart::kCorner, Vec3d::Zero()};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) {
    return {t.a + d1 / (d1 - d3) * ab, TrianglePart::kEdge, ab};
  }
  const Vec3d cx = x - t.c;
  const double d5 = ab.dot(cx), d6 = ac.dot(cx);
  if (d6 >= 0 && d5 <= d6) return {t.c, TrianglePart::kCorner, Vec3d::Zero()};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) {
    return {t.a + d2 / (d2 - d6) * ac, TrianglePart::kEdge, ac};
  }
  const double va = d3 * d6 - d5 * d4;
  const double toward_c = d4 - d3, toward_b = d5 - d6;
  if (va <= 0 && toward_c >= 0 && toward_b >= 0 && toward_c + toward_b > 0) {
    const Vec3d bc = t.c - t.b;
    return {t.b + toward_c / (toward_c + toward_b) * bc, TrianglePart::kEdge, bc};
  }
  const double sum = va + vb + vc;
  if (!(sum > 0)) return {t.a, TrianglePart::kCorner, Vec3d::Zero()};  // no area
  return {t.a + ab * (vb / sum) + ac * (vc / sum), TrianglePart::kFace, Vec3d::Zero()};
}

std::optional<double> hit(const Triangle& t, const Vec3d& origin, const Vec3d& direction,
                          double margin) {
  const Vec3d ab = t.b - t.a, ac = t.c - t.a;
  const Vec3d p = direction.cross(ac);
  const double determinant = ab.dot(p);
  if (determinant == 0) return std::nullopt;
  const Vec3d from_a = origin - t.a;
  const double u = from_a.dot(p) / determinant;
  if (!(u >= -margin && u <= 1 + margin)) return std::nullopt;
  const Vec3d q = from_a.cross(ab);
  const double v = direction.dot(q) / determinant;
  if (!(v >= -margin && u + v <= 1 + margin)) return std::nullopt;
  return ac.dot(q) / determinant;
}

}  // namespace ice_ice_baby
