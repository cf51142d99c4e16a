// The thread that builds and publishes messages, so that the simulation's thread does not.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "pacing.h"

namespace ice_ice_baby {

/// Runs one task per topic on request. A topic is busy from the request until its task has run, and
/// takes no second request meanwhile: at most one snapshot per topic waits, and nobody waits for a
/// slow task.
class PublisherThread {
 public:
  /// @param tasks one per topic. The data that a task reads may change only while its topic is not
  /// busy. A task that throws is logged, and its topic is free again.
  explicit PublisherThread(std::vector<std::function<void()>> tasks);
  /// Waits for the running task and drops the requests that still wait.
  ~PublisherThread();

  bool busy(std::size_t topic) const;

  /// Requests the task of a topic that is not busy. Returns at once.
  void request(std::size_t topic);

 private:
  void run();
  void runTask(std::size_t topic);

  const std::vector<std::function<void()>> tasks_;
  mutable std::mutex mutex_;  ///< guards the next three
  std::condition_variable changed_;
  std::vector<bool> busy_;
  bool stopping_ = false;
  RateGate log_gate_{0.1};  ///< publisher's thread
  std::thread thread_;
};

}  // namespace ice_ice_baby
