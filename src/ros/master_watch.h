// Registers the node again after the master was restarted, which roscpp does not do by itself.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace ice_ice_baby {

/// Every 2 s asks the master whether it still knows the first of `services`. If it answers no,
/// registers every publisher, subscriber and service of the process anew, without touching
/// connections that still stand.
class MasterWatch {
 public:
  /// @param services full names @param also called each time that the master is there
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
