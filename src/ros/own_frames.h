// The tf frames that this node sends.
#pragma once

#include <mutex>
#include <set>
#include <string>

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
    return names_.count(name) > 0;
  }

 private:
  mutable std::mutex mutex_;
  std::set<std::string> names_;
};

}  // namespace ice_ice_baby
