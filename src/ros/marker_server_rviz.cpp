#include <interactive_markers/interactive_marker_server.h>

#include "marker_server.h"

namespace ice_ice_baby {

namespace {

using visualization_msgs::InteractiveMarkerFeedback;
using Dragged = std::function<void(const std::string&, const geometry_msgs::PoseStamped&)>;

class RvizMarkers final : public MarkerServer {
 public:
  RvizMarkers(const std::string& topics, Dragged dragged)
      : dragged_(std::move(dragged)), server_(topics, "", true) {}

  void show(const std::vector<visualization_msgs::InteractiveMarker>& markers) override {
    server_.clear();
    for (const auto& marker : markers) {
      server_.insert(
          marker, [this](const InteractiveMarkerFeedback::ConstPtr& feedback) { take(*feedback); },
          InteractiveMarkerFeedback::POSE_UPDATE);
    }
    server_.applyChanges();
  }

  void put(const std::string& marker, const geometry_msgs::Pose& pose) override {
    server_.setPose(marker, pose);
    server_.applyChanges();
  }

 private:
  void take(const InteractiveMarkerFeedback& feedback) {
    geometry_msgs::PoseStamped pose;
    pose.header = feedback.header;
    pose.pose = feedback.pose;
    dragged_(feedback.marker_name, pose);
  }

  const Dragged dragged_;
  interactive_markers::InteractiveMarkerServer server_;
};

}  // namespace

std::unique_ptr<MarkerServer> makeMarkerServer(const std::string& topics, Dragged dragged) {
  return std::make_unique<RvizMarkers>(topics, std::move(dragged));
}

}  // namespace ice_ice_baby
