#include "master_watch.h"

#include <XmlRpc.h>
#include <ros/connection_manager.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/service_manager.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>

#include <chrono>

namespace ice_ice_baby {

namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue requestOf(const std::vector<std::string>& arguments) {
  XmlRpcValue request;
  request[0] = ros::this_node::getName();
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    request[static_cast<int>(k) + 1] = arguments[k];
  }
  return request;
}

/// Calls the master once, without waiting until it is reachable. @returns whether it succeeded
bool callMaster(const std::string& method, const std::vector<std::string>& arguments,
                XmlRpcValue& payload) {
  XmlRpcValue response;
  return ros::master::execute(method, requestOf(arguments), response, payload, false);
}

std::string ownUri() { return ros::XMLRPCManager::instance()->getServerURI(); }

/// Calls the node's own slave API, which lists what roscpp has registered.
/// @returns the payload, a list; empty if there was no answer
XmlRpcValue callSelf(const std::string& method, const XmlRpcValue& request) {
  std::string host;
  std::uint32_t port = 0;
  XmlRpcValue response, payload;
  payload.setSize(0);
  if (!ros::network::splitURI(ownUri(), host, port)) return payload;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  if (!client.execute(method.c_str(), request, response)) return payload;
  ros::XMLRPCManager::instance()->validateXmlrpcResponse(method, response, payload);
  return payload;
}

void registerPublishers() {
  const XmlRpcValue topics = callSelf("getPublications", requestOf({}));
  XmlRpcValue payload;
  for (int k = 0; k < topics.size(); ++k) {
    callMaster("registerPublisher", {topics[k][0], topics[k][1], ownUri()}, payload);
  }
}

void registerSubscribers() {
  const XmlRpcValue topics = callSelf("getSubscriptions", requestOf({}));
  for (int k = 0; k < topics.size(); ++k) {
    XmlRpcValue publishers;
    const std::string topic = topics[k][0];
    if (!callMaster("registerSubscriber", {topic, topics[k][1], ownUri()}, publishers)) continue;
    // An empty list would close connections to publishers that the new master does not know yet.
    if (publishers.size() == 0) continue;
    XmlRpcValue update = requestOf({topic});
    update[2] = publishers;
    callSelf("publisherUpdate", update);
  }
}

/// URI of the services of this process.
std::string serviceUri() {
  return "rosrpc://" + ros::network::getHost() + ":" +
         std::to_string(ros::ConnectionManager::instance()->getTCPPort());
}

void registerServices(const std::vector<std::string>& names, const std::string& uri) {
  XmlRpcValue payload;
  for (const std::string& name : names) {
    if (!ros::ServiceManager::instance()->lookupServicePublication(name)) continue;
    callMaster("registerService", {name, uri, ownUri()}, payload);
  }
}

}  // namespace

MasterWatch::MasterWatch(std::vector<std::string> services, std::function<void()> also)
    : services_(std::move(services)),
      also_(std::move(also)),
      service_uri_(serviceUri()),
      thread_([this] { run(); }) {}

MasterWatch::~MasterWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void MasterWatch::run() {
  bool away = false;
  while (waitFor2s()) {
    const bool there = ros::master::check();
    if (!there && !away) {
      ROS_WARN("The ROS master does not answer; the simulation goes on");
    }
    away = !there;
    if (away) continue;
    if (forgotten()) registerAgain();
    also_();
  }
}

bool MasterWatch::waitFor2s() {
  std::unique_lock<std::mutex> lock(mutex_);
  return !changed_.wait_for(lock, std::chrono::seconds(2), [this] { return stopping_; });
}

/// Whether the master answers that it does not know the service. During shutdown that is expected:
/// the node has then unregistered its services itself.
bool MasterWatch::forgotten() const {
  XmlRpcValue response, payload;
  const XmlRpcValue request = requestOf({services_.front()});
  if (ros::master::execute("lookupService", request, response, payload, false)) return false;
  return response.getType() == XmlRpcValue::TypeArray && response.size() > 0 &&
         response[0].getType() == XmlRpcValue::TypeInt && ros::master::check() &&
         !ros::isShuttingDown();
}

void MasterWatch::registerAgain() const {
  ROS_WARN("The ROS master does not know this node, probably after a restart; registering again");
  registerPublishers();
  registerSubscribers();
  registerServices(services_, service_uri_);
  const std::string& node = ros::this_node::getName();
  registerServices({node + "/get_loggers", node + "/set_logger_level", node + "/load_nodelet",
                    node + "/unload_nodelet", node + "/list"},
                   service_uri_);
}

}  // namespace ice_ice_baby
