// The tf frames that this node sends.
#pragma once

#include <mutex>
#include <set>
#include <string>
#include <utility>

namespace ice_ice_baby {

/// Names of child frames. Thread safe.
class OwnFrames {
 public:
  void set(std::set<std::string> names) {
    const std::lock_guard<std::mutex> lock(mutex_);
    names_ = std::move(names);
  }
  bool has(const std::string& name) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool slash = !name.empty() && name.front() == '/';  // which tf2 ignores
    return names_.count(name.substr(slash ? 1 : 0)) > 0;
  }

 private:
  mutable std::mutex mutex_;
  std::set<std::string> names_;
};

}  // namespace ice_ice_baby
