// SimulationClient against a real node, no node, and a node that hangs.
#include "simulation_client.h"

#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "patience.h"

namespace ice_ice_baby {
namespace {

/// A client and all that it was told.
class SimulationClientTest : public testing::Test {
 protected:
  SimulationClient::Callbacks listen() {
    SimulationClient::Callbacks callbacks;
    callbacks.answered = [this](const Answer& answer) {
      const std::lock_guard<std::mutex> lock(mutex_);
      answers_.push_back(answer);
    };
    callbacks.state = [this](const State& state) {
      const std::lock_guard<std::mutex> lock(mutex_);
      state_ = state;
      ++states_;
    };
    callbacks.scenes = [this](const std::vector<std::string>& scenes) {
      const std::lock_guard<std::mutex> lock(mutex_);
      scenes_ = scenes;
    };
    return callbacks;
  }

  /// The next answer of a service, taken out of the list.
  Answer answerOf(const std::string& service) {
    Answer found;
    EXPECT_TRUE(await([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto at = std::find_if(answers_.begin(), answers_.end(),
                                   [&](const Answer& a) { return a.service == service; });
      if (at == answers_.end()) return false;
      found = *at;
      answers_.erase(at);
      return true;
    })) << "no answer from "
        << service;
    return found;
  }

  State state() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return state_;
  }

  std::mutex mutex_;
  std::vector<Answer> answers_;
  std::vector<std::string> scenes_;
  State state_;
  unsigned states_ = 0;
  SimulationClient client_{listen()};
};

TEST_F(SimulationClientTest, followsStateAndLearnsScenes) {
  ASSERT_TRUE(client_.follow("/ice_ice_baby"));
  EXPECT_TRUE(answerOf("get_state").success);
  EXPECT_TRUE(await([this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    return states_ > 3;
  }));
  EXPECT_GT(state().particles, 0U);
  const std::lock_guard<std::mutex> lock(mutex_);
  EXPECT_NE(std::find(scenes_.begin(), scenes_.end(), "container_splash"), scenes_.end());
}

TEST_F(SimulationClientTest, setsTheTemperature) {
  ASSERT_TRUE(client_.follow("/ice_ice_baby"));
  client_.setTemperature(-7.0, 0.0);
  EXPECT_TRUE(answerOf("set_temperature").success);
  EXPECT_TRUE(await([this] { return state().temperature == -7.0; }));
}

TEST_F(SimulationClientTest, handsBackARefusalInTheNodesWords) {
  ASSERT_TRUE(client_.follow("/ice_ice_baby"));
  client_.setTemperature(-1000.0, 0.0);
  const Answer cold = answerOf("set_temperature");
  EXPECT_TRUE(cold.reached);
  EXPECT_FALSE(cold.success);
  EXPECT_FALSE(cold.message.empty());
  client_.reset("no_such_scene", "");
  const Answer unknown = answerOf("reset");
  EXPECT_TRUE(unknown.reached);
  EXPECT_FALSE(unknown.success);
}

TEST_F(SimulationClientTest, pausesStepsResumesAndResets) {
  ASSERT_TRUE(client_.follow("/ice_ice_baby"));
  client_.pause();
  EXPECT_TRUE(answerOf("pause").success);
  client_.refresh();
  EXPECT_TRUE(await([this] { return state().paused; }));
  client_.step(2);
  EXPECT_TRUE(answerOf("step").success);
  client_.reset("dam_break", "");
  EXPECT_TRUE(answerOf("reset").success);
  client_.resume();
  EXPECT_TRUE(answerOf("resume").success);
  EXPECT_TRUE(await([this] { return state().scene == "dam_break" && !state().paused; }));
}

TEST_F(SimulationClientTest, saysThatThereIsNoNode) {
  ASSERT_TRUE(client_.follow("/nobody"));
  client_.pause();
  const Answer answer = answerOf("pause");
  EXPECT_FALSE(answer.reached);
  EXPECT_EQ(answer.message, "no node at /nobody");
}

TEST_F(SimulationClientTest, refusesWhatIsNoName) {
  EXPECT_FALSE(client_.follow(""));
  EXPECT_FALSE(client_.follow("two words"));
  EXPECT_EQ(client_.node(), "");
}

TEST_F(SimulationClientTest, isNotHeldUpByANodeThatHangs) {
  ros::CallbackQueue never_served;
  ros::NodeHandle hanging("/hanging");
  hanging.setCallbackQueue(&never_served);
  const boost::function<bool(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&)> nothing =
      [](auto&, auto&) { return true; };
  const ros::ServiceServer server =
      hanging.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>("pause",
                                                                                        nothing);
  auto client = std::make_unique<SimulationClient>(listen());
  ASSERT_TRUE(client->follow("/hanging"));
  EXPECT_FALSE(answerOf("get_state").reached);
  client->pause();
  ASSERT_TRUE(await([&] { return !never_served.isEmpty(); })) << "the call did not arrive";
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(client->follow("/ice_ice_baby"));  // breaks the call off
  EXPECT_TRUE(answerOf("get_state").success);
  client->setTemperature(1.0, 0.0);
  EXPECT_TRUE(answerOf("set_temperature").success);
  client.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(8));
}

}  // namespace
}  // namespace ice_ice_baby

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulation_client_test");
  const ros::NodeHandle keeps_ros_running;
  ros::service::waitForService("/ice_ice_baby/get_state", 20000);
  return RUN_ALL_TESTS();
}
