#include "successor.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>

#include <string>

namespace ice_ice_baby {

namespace {

constexpr const char* kShutdown = "shutdown";

}  // namespace

Successor::Successor() {
  const auto& manager = ros::XMLRPCManager::instance();
  manager->unbind(kShutdown);
  manager->bind(kShutdown, [this](XmlRpc::XmlRpcValue& request, XmlRpc::XmlRpcValue& response) {
    shutdown(request, response);
  });
}

Successor::~Successor() { ros::XMLRPCManager::instance()->unbind(kShutdown); }

void Successor::shutdown(const XmlRpc::XmlRpcValue& request, XmlRpc::XmlRpcValue& response) {
  const bool told = request.getType() == XmlRpc::XmlRpcValue::TypeArray && request.size() > 1 &&
                    request[1].getType() == XmlRpc::XmlRpcValue::TypeString;
  const std::string reason = told ? static_cast<const std::string&>(request[1]) : "";
  registered_ = reason.find("new node registered") != std::string::npos;
  if (registered_) {
    ROS_FATAL(
        "Another node has registered as %s, so this one ends: the ROS master keeps only the newest "
        "node of a name. To run both, start one with another name, for example __name:=second.",
        ros::this_node::getName().c_str());
  } else {
    ROS_WARN("Asked to shut down: %s", reason.c_str());
  }
  response = ros::xmlrpc::responseInt(1, "", 0);
  ros::requestShutdown();
}

}  // namespace ice_ice_baby
