#include "metrics/rigid_fit.h"

#include <Eigen/SVD>
#include <algorithm>
#include <map>
#include <numeric>

namespace ice_ice_baby {

namespace {

Vec3d meanOf(const std::vector<Vec3d>& points, const std::vector<std::size_t>& members) {
  Vec3d sum = Vec3d::Zero();
  for (const std::size_t k : members) sum += points[k];
  return sum / double(members.size());
}

/// Union-find forest: each point refers to a point of its group, and roots refer to themselves.
class Forest {
 public:
  explicit Forest(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), std::size_t(0));
  }
  std::size_t root(std::size_t k) {
    while (parents_[k] != k) k = parents_[k] = parents_[parents_[k]];
    return k;
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t one = root(a), other = root(b);
    parents_[std::max(one, other)] = std::min(one, other);
  }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace

double squaredRigidMisfit_m2(const std::vector<Vec3d>& before, const std::vector<Vec3d>& after,
                             const std::vector<std::size_t>& members) {
  if (members.empty()) return 0.0;
  const Vec3d from = meanOf(before, members), to = meanOf(after, members);
  Mat3<double> covariance = Mat3<double>::Zero();
  for (const std::size_t k : members) {
    covariance += (before[k] - from) * (after[k] - to).transpose();
  }
  const Eigen::JacobiSVD<Mat3<double>> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3<double> upright = Mat3<double>::Identity();
  upright(2, 2) = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  const Mat3<double> rotation = svd.matrixV() * upright * svd.matrixU().transpose();
  double sum = 0.0;
  for (const std::size_t k : members) {
    sum += (after[k] - to - rotation * (before[k] - from)).squaredNorm();
  }
  return sum;
}

std::vector<std::vector<std::size_t>> connectedGroups(
    std::size_t count, const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
  Forest forest(count);
  for (const auto& [a, b] : pairs) forest.join(a, b);
  std::map<std::size_t, std::vector<std::size_t>> by_root;
  for (std::size_t k = 0; k < count; ++k) by_root[forest.root(k)].push_back(k);
  std::vector<std::vector<std::size_t>> groups;
  groups.reserve(by_root.size());
  for (auto& [root, members] : by_root) groups.push_back(std::move(members));
  return groups;
}

}  // namespace ice_ice_baby
