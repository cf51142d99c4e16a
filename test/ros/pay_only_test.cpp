// Topics without subscribers cost nothing: what they ask of the simulation, call by call.
#include <geometry_msgs/WrenchStamped.h>
#include <gtest/gtest.h>
#include <ice_ice_baby/Vessels.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <map>

#include "frames.h"
#include "ice_ice_baby/scene_loader.h"
#include "topics.h"

namespace ice_ice_baby {
namespace {

/// Counts calls of a simulation.
class Watched final : public Simulation {
 public:
  explicit Watched(const Scene& scene) : real_(makeSimulation(scene, Precision::kFloat, 1)) {}

  const StepReport& advanceFrame() override { return real_->advanceFrame(); }
  const StepReport& report() const override { return real_->report(); }
  const Scene& scene() const override { return real_->scene(); }
  void setTemperature(double c, double s, const std::string& target) override {
    real_->setTemperature(c, s, target);
  }
  void heatRegion(const HeatedRegion& region) override { real_->heatRegion(region); }
  void setSource(const std::string& name, bool open, double flow_l_min) override {
    real_->setSource(name, open, flow_l_min);
  }
  void setHeatRegion(const std::string& name, bool active, double power_w) override {
    real_->setHeatRegion(name, active, power_w);
  }
  void moveHeatRegion(const std::string& name, const Posed& pose) override {
    real_->moveHeatRegion(name, pose);
  }
  Posed solidPose(const std::string& name) const override { return real_->solidPose(name); }
  Posed heatRegionPose(const std::string& name) const override {
    return real_->heatRegionPose(name);
  }
  void moveSource(const std::string& name, const Posed& pose) override {
    real_->moveSource(name, pose);
  }
  void placeSource(const std::string& name, const Posed& pose) override {
    real_->placeSource(name, pose);
  }
  Posed sourcePose(const std::string& name) const override { return real_->sourcePose(name); }
  void setGravity(const Vec3d& gravity) override { real_->setGravity(gravity); }
  void moveCollider(const std::string& name, const Posed& pose) override {
    ++moves;
    real_->moveCollider(name, pose);
  }
  void placeColliders(const std::vector<ColliderPlacement>& placements) override {
    ++moves;
    real_->placeColliders(placements);
  }
  Posed colliderPose(const std::string& name) const override {
    ++poses;
    return real_->colliderPose(name);
  }
  std::vector<SolidState> solids() const override { return real_->solids(); }
  void holdSolid(const std::string& name, const Posed& pose) override {
    real_->holdSolid(name, pose);
  }
  void releaseSolid(const std::string& name) override { real_->releaseSolid(name); }
  void sample(std::vector<ParticleSample>& out, std::size_t stride) const override {
    ++samples;
    real_->sample(out, stride);
  }
  void sampleSprings(std::vector<SpringSample>& out, std::size_t limit) const override {
    ++spring_samples;
    real_->sampleSprings(out, limit);
  }
  void sampleRelativeVolumes(std::vector<float>& out) const override {
    real_->sampleRelativeVolumes(out);
  }
  void countFlows(bool on) override {
    counts_flows = on;
    real_->countFlows(on);
  }
  std::vector<VesselReport> vessels() const override {
    ++vessel_reports;
    return real_->vessels();
  }
  void measureWrenches(bool measure) override {
    measures_wrenches = measure;
    real_->measureWrenches(measure);
  }
  std::vector<ColliderWrench> wrenches() const override { return real_->wrenches(); }
  std::vector<StageStats> stages() const override { return real_->stages(); }
  std::uint64_t stateHash() const override { return real_->stateHash(); }
  Precision precision() const override { return real_->precision(); }
  void write(StateWriter& writer) const override { real_->write(writer); }

  mutable int samples = 0, spring_samples = 0, poses = 0, moves = 0, vessel_reports = 0;
  bool counts_flows = false, measures_wrenches = false;

 private:
  std::unique_ptr<Simulation> real_;
};

class PayOnly : public testing::Test {
 protected:
  PayOnly() : simulation_(loadScene("small")) {
    parameters_.particles_rate_hz = parameters_.state_rate_hz = 1000.0;
    topics_ = std::make_unique<Topics>(node_, parameters_);
    topics_->sceneStarted(simulation_);
    tick();
    while (messages()["colliders"] == 0) ros::WallDuration(0.001).sleep();  // latched
    simulation_.poses = 0;
  }

  /// What the simulation thread does after a frame.
  void tick() {
    Snapshot snapshot;
    snapshot.report = simulation_.report();
    topics_->publish(simulation_, snapshot, ros::Time::now(), false, false);
  }

  void runFrames(int count) {
    for (int k = 0; k < count; ++k) {
      ros::WallDuration(0.002).sleep();  // longer than the 1000 Hz that the topics allow
      topics_->frameBegins(simulation_);
      simulation_.advanceFrame();
      tick();
    }
  }

  /// Runs frames, each once the cloud of the one before is published, so that none is skipped.
  void runPublishedFrames(int count) {
    const std::uint64_t before = messages()["particles"];
    for (int k = 1; k <= count; ++k) {
      runFrames(1);
      for (int wait = 0; wait < 5000 && messages()["particles"] < before + k; ++wait) {
        ros::WallDuration(0.001).sleep();
        tick();
      }
    }
  }

  std::map<std::string, std::uint64_t> messages() const {
    std::map<std::string, std::uint64_t> messages;
    for (const TopicLoad& load : topics_->loads()) {
      messages[load.name.substr(load.name.rfind('/') + 1)] = load.messages;
    }
    return messages;
  }

  /// A subscriber that has received its first message.
  template <class Message>
  ros::Subscriber subscribe(const std::string& topic, int& received) {
    const auto subscriber = node_.subscribe<Message>(
        topic, 100, [&received](const typename Message::ConstPtr&) { ++received; });
    for (int k = 0; k < 40 || received == 0; ++k) {
      if (k == 2000) throw std::runtime_error("no message on " + topic);
      ros::WallDuration(0.005).sleep();
      ros::spinOnce();
      tick();
    }
    received = 0;
    return subscriber;
  }

  ros::NodeHandle node_{"~"};
  NodeParameters parameters_;
  Watched simulation_;
  std::unique_ptr<Topics> topics_;
};

TEST_F(PayOnly, WrenchesAreMeasuredWhileSomebodySubscribes) {
  runFrames(3);
  EXPECT_FALSE(simulation_.measures_wrenches);
  const std::string collider = simulation_.scene().containers.at(0).name;
  std::vector<geometry_msgs::WrenchStamped> received;
  ros::Subscriber subscriber = node_.subscribe<geometry_msgs::WrenchStamped>(
      "wrenches/" + collider, 100,
      [&](const geometry_msgs::WrenchStamped::ConstPtr& message) { received.push_back(*message); });
  for (int k = 0; k < 2000 && received.size() < 3; ++k) {
    runFrames(1);
    ros::spinOnce();
  }
  EXPECT_TRUE(simulation_.measures_wrenches);
  ASSERT_GE(received.size(), 3u);
  EXPECT_EQ(received[0].header.frame_id, parameters_.scene_frame + "/" + collider);
  subscriber.shutdown();
  for (int k = 0; k < 2000 && simulation_.measures_wrenches; ++k) runFrames(1);
  EXPECT_FALSE(simulation_.measures_wrenches);
}

TEST_F(PayOnly, WithoutSubscribersNothingIsSampledOrBuilt) {
  const auto before = messages();
  runFrames(50);
  EXPECT_EQ(messages(), before);
  EXPECT_EQ(simulation_.samples, 0);
  EXPECT_EQ(simulation_.spring_samples, 0);
  EXPECT_EQ(simulation_.poses, 0);
  EXPECT_EQ(simulation_.vessel_reports, 0);
  EXPECT_FALSE(simulation_.counts_flows);
}

TEST_F(PayOnly, OneSubscriberCostsOneMessageAFrameOfItsTopic) {
  int received = 0;
  const auto subscriber = subscribe<sensor_msgs::PointCloud2>("particles", received);
  auto expected = messages();
  simulation_.samples = 0;
  runPublishedFrames(50);
  expected["particles"] += 50;
  EXPECT_EQ(messages(), expected);
  EXPECT_EQ(simulation_.samples, 50);
  EXPECT_EQ(simulation_.spring_samples, 0);
  EXPECT_EQ(simulation_.poses, 0);
  for (int k = 0; k < 1000 && received < 50; ++k) {
    ros::WallDuration(0.005).sleep();
    ros::spinOnce();
  }
  EXPECT_EQ(received, 50);
}

TEST_F(PayOnly, VesselsAreMeasuredWhileSomebodySubscribes) {
  int received = 0;
  {
    const auto subscriber = subscribe<Vessels>("vessels", received);
    runFrames(3);
    EXPECT_TRUE(simulation_.counts_flows);
    EXPECT_GT(simulation_.vessel_reports, 0);
  }
  runFrames(20);
  simulation_.vessel_reports = 0;
  runFrames(20);
  EXPECT_FALSE(simulation_.counts_flows);
  EXPECT_EQ(simulation_.vessel_reports, 0);
}

TEST_F(PayOnly, ATickWithoutAFrameBuildsNothing) {
  int received = 0;
  const auto subscriber = subscribe<sensor_msgs::PointCloud2>("particles", received);
  runPublishedFrames(1);
  simulation_.samples = 0;
  for (int k = 0; k < 20; ++k) tick();
  EXPECT_EQ(simulation_.samples, 0);
}

TEST_F(PayOnly, AFrameThatThePublisherHasNoTimeForIsNotSampled) {
  int received = 0;
  const auto subscriber = subscribe<sensor_msgs::PointCloud2>("particles", received);
  const std::uint64_t before = messages()["particles"];
  simulation_.samples = 0;
  runFrames(200);
  EXPECT_GT(simulation_.samples, 0);
  const std::uint64_t expected = before + std::uint64_t(simulation_.samples);
  for (int k = 0; k < 5000 && messages()["particles"] < expected; ++k) {
    ros::WallDuration(0.001).sleep();
  }
  EXPECT_EQ(messages()["particles"], expected);
}

TEST_F(PayOnly, ASubscriberThatLeftCostsNothing) {
  int received = 0;
  subscribe<sensor_msgs::PointCloud2>("particles", received).shutdown();
  const auto before = messages();
  simulation_.samples = 0;
  runFrames(20);
  EXPECT_EQ(messages(), before);
  EXPECT_EQ(simulation_.samples, 0);
}

TEST_F(PayOnly, CollidersThatFollowNoFrameAreNotAskedFor) {
  Frames frames(node_, parameters_);
  frames.sceneStarted(simulation_, ros::Time::now());
  simulation_.poses = 0;
  for (int k = 0; k < 20; ++k) {
    frames.moveFollowers(simulation_, ros::Time::now());
    simulation_.advanceFrame();
    EXPECT_FALSE(frames.publishFollowers(simulation_, ros::Time::now()));
  }
  EXPECT_EQ(simulation_.poses, 0);
  EXPECT_EQ(simulation_.moves, 0);
}

}  // namespace
}  // namespace ice_ice_baby

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "pay_only_test");
  const ros::NodeHandle keep_started;
  return RUN_ALL_TESTS();
}
