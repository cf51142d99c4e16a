// Topics while the simulation runs: threads that meet, and subscribers in the same process.
#include "topics.h"

#include <gtest/gtest.h>
#include <ice_ice_baby/State.h>
#include <ros/ros.h>
#include <visualization_msgs/MarkerArray.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <set>

#include "ice_ice_baby/scene_loader.h"

namespace {

/// Allocations of at least `counted_size` bytes.
std::atomic<std::size_t> counted_size{SIZE_MAX};
std::atomic<int> allocations{0};

void* counted(std::size_t size) {
  if (size >= counted_size) ++allocations;
  void* memory = std::malloc(size);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Those of roscpp and of the node among them.
void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace ice_ice_baby {
namespace {

using sensor_msgs::PointCloud2;

template <class Condition>
bool becomes(const Condition& condition) {
  for (int k = 0; k < 2000; ++k) {
    ros::spinOnce();
    if (condition()) return true;
    ros::WallDuration(0.005).sleep();
  }
  return false;
}

TEST(RatedTopic, SubscriberInTheProcessGetsThePublishedMessageItself) {
  ros::NodeHandle node("~");
  RatedTopic topic(1000.0);
  topic.advertise<PointCloud2>(node, "direct");
  PointCloud2::ConstPtr received;
  const auto subscriber = node.subscribe<PointCloud2>(
      "direct", 1, [&](const PointCloud2::ConstPtr& message) { received = message; });
  ASSERT_TRUE(becomes([&] { return topic.load().subscribers == 1; }));
  const auto message = boost::make_shared<PointCloud2>();
  topic.publish(message);
  ASSERT_TRUE(becomes([&] { return received != nullptr; }));
  EXPECT_EQ(received.get(), message.get());
  EXPECT_EQ(topic.load().messages, 1u);
}

class TopicsTest : public testing::Test {
 protected:
  TopicsTest() : small_(loadScene("small")) {
    parameters_.particles_rate_hz = parameters_.state_rate_hz = 1000.0;
    topics_ = std::make_unique<Topics>(node_, parameters_);
  }

  /// Runs `scene` as fast as it goes, with the hooks of the node.
  std::unique_ptr<SimulationThread> run(const Scene& scene) {
    RunOptions options;
    options.threads = 1;
    options.real_time_factor = 0.0;
    RunHooks hooks;
    hooks.started = [this](const Simulation& now) { topics_->sceneStarted(now); };
    hooks.tick = [this](const Simulation& now, const Snapshot& snapshot, bool settled) {
      topics_->publish(now, snapshot, ros::Time::now(), true, settled);
    };
    return std::make_unique<SimulationThread>(scene, options, hooks);
  }

  ros::NodeHandle node_{"~"};
  NodeParameters parameters_;
  const Scene small_;
  std::unique_ptr<Topics> topics_;
};

TEST_F(TopicsTest, CloudsReachASubscriberInTheProcessWithoutACopy) {
  std::size_t size = 0;
  const PointCloud2* latest = nullptr;
  int received = 0, repeated = 0;
  const auto subscriber =
      node_.subscribe<PointCloud2>("particles", 1, [&](const PointCloud2::ConstPtr& cloud) {
        size = cloud->data.size();
        repeated += cloud.get() == latest;
        latest = cloud.get();
        ++received;
      });
  const auto simulation = makeSimulation(small_, Precision::kFloat, 1);
  Snapshot snapshot;
  bool counts = false;
  const auto publishFrame = [&] {
    simulation->advanceFrame();
    snapshot.report = simulation->report();
    const int before = received;
    if (counts) counted_size = size;
    const bool arrived = becomes([&] {
      topics_->publish(*simulation, snapshot, ros::Time::now(), false, false);
      return received > before;
    });
    counted_size = SIZE_MAX;
    return arrived;
  };
  topics_->sceneStarted(*simulation);
  for (int k = 0; k < 3; ++k) ASSERT_TRUE(publishFrame());  // warm up: buffers have their size
  ASSERT_EQ(size, 216u * 48u);
  repeated = 0;
  counts = true;
  for (int k = 0; k < 20; ++k) ASSERT_TRUE(publishFrame());
  // A copy on the way would be serialised into a buffer of this size, and read into another.
  EXPECT_EQ(allocations, 0);
  EXPECT_GT(repeated, 10);  // the publisher got its own message back and filled it again
}

TEST_F(TopicsTest, AMessageThatASubscriberHoldsDoesNotChange) {
  std::vector<PointCloud2::ConstPtr> held;
  std::vector<std::vector<std::uint8_t>> copies;
  const auto subscriber =
      node_.subscribe<PointCloud2>("particles", 10, [&](const PointCloud2::ConstPtr& cloud) {
        if (held.size() == 10) return;
        held.push_back(cloud);
        copies.push_back(cloud->data);
      });
  const auto thread = run(small_);
  ASSERT_TRUE(becomes([&] { return held.size() == 10; }));
  const std::uint64_t frame = thread->snapshot().report.frame;
  ASSERT_TRUE(becomes([&] { return thread->snapshot().report.frame > frame + 10; }));
  for (std::size_t k = 0; k < held.size(); ++k) {
    EXPECT_EQ(held[k]->data, copies[k]);
    EXPECT_TRUE(k == 0 || (held[k] != held[k - 1] && copies[k] != copies[k - 1]));
  }
}

/// What three subscribers have received.
class Received {
 public:
  explicit Received(ros::NodeHandle& node) {
    particles_ = node.subscribe<PointCloud2>("particles", 10, [&](const PointCloud2::ConstPtr& m) {
      note(m->header, particles);
      widths_known = widths_known && (m->width == 216 || m->width == 0 || m->width == width_other);
    });
    state_ = node.subscribe<State>("state", 10,
                                   [&](const State::ConstPtr& m) { note(m->header, states); });
    colliders_ = node.subscribe<visualization_msgs::MarkerArray>(
        "colliders", 10, [&](const visualization_msgs::MarkerArray::ConstPtr& m) {
          note(m->markers.at(0).header, colliders);
          drawn.clear();
          for (const visualization_msgs::Marker& marker : m->markers) drawn.insert(marker.ns);
        });
  }

  struct Count {
    int messages = 0;
    ros::Time latest;
  };
  Count particles, states, colliders;
  std::uint32_t width_other = 0;
  bool widths_known = true, ordered = true;
  std::set<std::string> drawn;  ///< names in the latest message of colliders

 private:
  void note(const std_msgs::Header& header, Count& count) {
    ordered = ordered && header.stamp >= count.latest;
    count.latest = header.stamp;
    ++count.messages;
  }

  ros::Subscriber particles_, state_, colliders_;
};

TEST_F(TopicsTest, ThreadsMeetInResetsAndLoadsAndMessagesStayInOrder) {
  Received received(node_);
  const Scene warm = loadScene("warm");
  received.width_other = static_cast<std::uint32_t>(particleCount(warm));
  const auto thread = run(small_);
  for (int k = 0; k < 24; ++k) {
    const int before = received.particles.messages;
    ASSERT_TRUE(becomes([&] { return received.particles.messages > before + 2; }));
    if (k % 2) {
      thread->reset(k % 4 == 1 ? small_ : warm);
    } else {
      thread->load(makeSimulation(small_, Precision::kDouble, 1));
    }
    topics_->loads();
  }
  // The colliders of the last scene are not lost, however busy the publisher was.
  EXPECT_TRUE(becomes([&] { return received.drawn.count("plate") == 1; }));
  EXPECT_TRUE(received.ordered);
  EXPECT_TRUE(received.widths_known);
  EXPECT_GT(received.states.messages, 20);
  EXPECT_GT(received.colliders.messages, 5);
}

TEST_F(TopicsTest, ThreadsEndWhileMessagesAreBuilt) {
  for (int k = 0; k < 10; ++k) {
    int received = 0;
    const auto subscriber = node_.subscribe<PointCloud2>(
        "particles", 1, [&](const PointCloud2::ConstPtr&) { ++received; });
    auto thread = run(small_);
    ASSERT_TRUE(becomes([&] { return received > 2; }));
    thread.reset();
    topics_ = std::make_unique<Topics>(node_, parameters_);
  }
}

}  // namespace
}  // namespace ice_ice_baby

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "topics_test");
  const ros::NodeHandle keep_started;
  return RUN_ALL_TESTS();
}
