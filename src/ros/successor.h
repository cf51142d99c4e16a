// Another node that takes the name of this one.
#pragma once

#include <XmlRpcValue.h>

#include <atomic>

namespace ice_ice_baby {

/// The master lets the newest node of a name live and asks the one before it to end, which roscpp
/// does with exit code 0 and a word that is easily missed. Answers that request in roscpp's place
/// and says what has happened. One per process, after ros::start.
class Successor {
 public:
  Successor();
  ~Successor();

  /// Whether this node ends because another has its name now.
  bool registered() const { return registered_; }

 private:
  void shutdown(const XmlRpc::XmlRpcValue& request, XmlRpc::XmlRpcValue& response);

  std::atomic<bool> registered_{false};
};

}  // namespace ice_ice_baby
