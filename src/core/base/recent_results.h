// Results that take long to compute, kept for the next who needs the same.
#pragma once

#include <deque>
#include <memory>
#include <mutex>

namespace ice_ice_baby {

/// The latest results of one kind, so that a reset, or a second simulation of the same scene, does
/// not compute them again. Thread safe.
/// @tparam Value immutable; bytes() is its memory
template <class Value>
class RecentResults {
 public:
  using Result = std::shared_ptr<const Value>;

  /// @param max_bytes memory of what nobody but this list may use; older results are dropped
  explicit RecentResults(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  /// The kept result for which matches(value) is true, else the result of make().
  template <class Matches, class Make>
  Result find(const Matches& matches, const Make& make) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      for (const Result& kept : kept_) {
        if (matches(*kept)) return kept;
      }
    }
    Result made = make();  // not under the lock, as it may use every thread
    keep(made);
    return made;
  }

 private:
  void keep(const Result& made) {
    const std::lock_guard<std::mutex> lock(mutex_);
    bytes_ += made->bytes();
    kept_.push_back(made);
    while (bytes_ > max_bytes_) {
      bytes_ -= kept_.front()->bytes();
      kept_.pop_front();
    }
  }

  std::mutex mutex_;
  std::deque<Result> kept_;
  std::size_t bytes_ = 0;  ///< of all that are kept
  std::size_t max_bytes_;
};

}  // namespace ice_ice_baby
