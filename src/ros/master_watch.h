// Registers the node again after a restart of the master, which roscpp does not do.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace ice_ice_baby {

/// Asks the master every 2 s whether it knows the first of `services`. If not, registers every
/// publisher, subscriber and service of the process again, and keeps existing connections.
class MasterWatch {
 public:
  /// @param services full names @param also called each time the master answers
  MasterWatch(std::vector<std::string> services, std::function<void()> also);
  ~MasterWatch();

 private:
  void run();
  bool waitFor2s();
  bool forgotten() const;
  void registerAgain() const;

  const std::vector<std::string> services_;
  const std::function<void()> also_;
  const std::string service_uri_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace ice_ice_baby
