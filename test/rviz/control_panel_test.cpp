// The panel's own buttons, pressed on a screen that is not there, against a real node.
#include "control_panel.h"

#include <gtest/gtest.h>
#include <ice_ice_baby/GetState.h>
#include <ros/ros.h>
#include <rviz/config.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <boost/function.hpp>

#include "heated_node.h"
#include "patience.h"

namespace ice_ice_baby {
namespace {

class ControlPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    panel_.show();
    ASSERT_TRUE(awaitGui([this] { return scene()->count() > 1 && text("particles_value") != "—"; }))
        << text("answer").toStdString();
  }

  template <typename Condition>
  static bool awaitGui(Condition condition) {
    return await([&] {
      QApplication::processEvents();
      return condition();
    });
  }

  template <typename Widget>
  Widget* child(const char* name) {
    auto* widget = panel_.findChild<Widget*>(name);
    EXPECT_NE(widget, nullptr) << name;
    return widget;
  }

  QString text(const char* label) { return child<QLabel>(label)->text(); }
  void follow(const char* node) {
    child<QLineEdit>("node")->setText(node);
    Q_EMIT child<QLineEdit>("node")->editingFinished();
  }

  QComboBox* scene() { return child<QComboBox>("scene"); }

  /// What a person's choice in a combo box does.
  static void choose(QComboBox* box, const QString& item) {
    box->setCurrentText(item);
    Q_EMIT box->activated(box->currentIndex());
  }

  ControlPanel panel_;
};

TEST_F(ControlPanelTest, showsTheNodesScenesAndNumbers) {
  EXPECT_GE(scene()->findText("container_splash"), 0);
  EXPECT_TRUE(awaitGui([this] { return text("temperature_in_force").contains("°C"); }));
  EXPECT_TRUE(text("density_error_value").contains("%"));
}

TEST_F(ControlPanelTest, sliderSetsTheTemperature) {
  child<QDoubleSpinBox>("ramp")->setValue(0.0);
  child<QSlider>("temperature_slider")->setValue(-12);
  EXPECT_TRUE(awaitGui([this] { return text("temperature_in_force").contains("-12.0 °C"); }));
  EXPECT_TRUE(text("answer").startsWith("set_temperature")) << text("answer").toStdString();
}

TEST_F(ControlPanelTest, pausesStepsAndResumes) {
  auto* pause = child<QPushButton>("pause_button");
  pause->click();
  ASSERT_TRUE(awaitGui([&] { return pause->text() == "Resume"; }));
  const QString before = text("time_value");
  child<QPushButton>("step_button")->click();
  EXPECT_TRUE(awaitGui([&] { return text("time_value") != before; }));
  pause->click();
  EXPECT_TRUE(awaitGui([&] { return pause->text() == "Pause"; }));
}

TEST_F(ControlPanelTest, startsTheChosenSceneAndPreset) {
  choose(scene(), "dam_break");
  EXPECT_TRUE(awaitGui([this] { return text("scene_value").startsWith("dam_break"); }));
  choose(child<QComboBox>("preset"), "paper");
  EXPECT_TRUE(awaitGui([this] { return text("scene_value").contains("(paper)"); }));
  child<QPushButton>("reset_button")->click();
  EXPECT_TRUE(awaitGui([this] { return text("answer").startsWith("reset"); }));
}

TEST_F(ControlPanelTest, offersNoTargetsWithoutHeat) {
  EXPECT_FALSE(child<QComboBox>("temperature_target")->isVisible());
  EXPECT_EQ(child<QSlider>("temperature_slider")->maximum(), 40);
}

TEST_F(ControlPanelTest, setsTheTemperatureOfAColliderOfASceneWithHeat) {
  HeatedNode heated;
  follow("/heated");
  auto* target = child<QComboBox>("temperature_target");
  ASSERT_TRUE(awaitGui([&] { return target->count() == 3; }));
  EXPECT_TRUE(target->isVisible());
  EXPECT_EQ(target->currentText(), "air");
  EXPECT_EQ(text("temperature_in_force"), "air 20.0 °C, mean 3.5 °C");
  EXPECT_EQ(child<QProgressBar>("ice_bar")->text(), "25 % ice, 7 steam");
  choose(target, "plate");
  child<QSlider>("temperature_slider")->setValue(120);
  ASSERT_TRUE(awaitGui([&] { return heated.asked().target == "plate"; }));
  EXPECT_EQ(heated.asked().temperature, 120.0);
  EXPECT_TRUE(awaitGui([this] { return text("answer").startsWith("set_temperature"); }));
  EXPECT_EQ(child<QSlider>("temperature_slider")->value(), 120);  // not the air's
}

TEST_F(ControlPanelTest, saysThatThereIsNoNode) {
  follow("/nobody");
  EXPECT_TRUE(awaitGui([this] { return text("answer") == "no node at /nobody"; }));
  EXPECT_EQ(text("particles_value"), "—");
}

TEST_F(ControlPanelTest, listsTheScenesOfANodeThatAnswersAfterItsFirstStates) {
  follow("/late");
  ros::NodeHandle node("/late");
  ros::AsyncSpinner spinner(1);
  spinner.start();
  const ros::Publisher states = node.advertise<State>("state", 1);
  State state;
  state.particles = 100;
  const auto publishUntil = [&](auto condition) {
    return awaitGui([&] {
      states.publish(state);
      return condition();
    });
  };
  ASSERT_TRUE(publishUntil([this] { return text("particles_value") == "100"; }));
  const boost::function<bool(GetState::Request&, GetState::Response&)> answer =
      [](GetState::Request&, GetState::Response& response) {
        response.scenes = {"late_scene"};
        return response.success = true;
      };
  const ros::ServiceServer server = node.advertiseService("get_state", answer);
  EXPECT_TRUE(publishUntil([this] { return scene()->findText("late_scene") >= 0; }));
}

TEST_F(ControlPanelTest, keepsNodeAndRampInTheConfig) {
  child<QDoubleSpinBox>("ramp")->setValue(7.5);
  rviz::Config config;
  panel_.save(config);
  ControlPanel loaded;
  loaded.load(config);
  EXPECT_EQ(loaded.findChild<QLineEdit*>("node")->text(), "/ice_ice_baby");
  EXPECT_DOUBLE_EQ(loaded.findChild<QDoubleSpinBox*>("ramp")->value(), 7.5);
}

}  // namespace
}  // namespace ice_ice_baby

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "control_panel_test");
  const QApplication application(argc, argv);
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
