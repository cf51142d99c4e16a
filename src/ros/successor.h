// Shutdown because another node took the name of this one.
#pragma once

#include <XmlRpcValue.h>

#include <atomic>

namespace ice_ice_baby {

/// The master keeps the newest node of a name and asks the earlier one to shut down. roscpp then
/// exits with code 0 and hardly a message. This class handles the request instead and logs the
/// reason. One per process, after ros::start.
class Successor {
 public:
  Successor();
  ~Successor();

  /// Whether this node ends because another one took its name.
  bool registered() const { return registered_; }

 private:
  void shutdown(const XmlRpc::XmlRpcValue& request, XmlRpc::XmlRpcValue& response);

  std::atomic<bool> registered_{false};
};

}  // namespace ice_ice_baby
