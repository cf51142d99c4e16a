// Private parameters: read, refused by name, listed.
#include "parameters.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {
namespace {

using XmlRpc::XmlRpcValue;

std::string refusal(const XmlRpcValue& tree) {
  try {
    readParameters(tree);
  } catch (const InvalidInput& e) {
    return e.what();
  }
  return "";
}

template <class Value>
XmlRpcValue with(const std::string& name, const Value& value) {
  XmlRpcValue tree;
  tree[name] = value;
  return tree;
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Parameters, DefaultsHoldWithoutAny) {
  const NodeParameters read = readParameters(XmlRpcValue());
  const NodeParameters defaults;
  EXPECT_EQ(read.scene, defaults.scene);
  EXPECT_EQ(read.particles_rate_hz, defaults.particles_rate_hz);
  EXPECT_EQ(read.precision, defaults.precision);
  EXPECT_TRUE(read.overrides.empty());
}

TEST(Parameters, AreRead) {
  XmlRpcValue tree;
  tree["scene"] = "dam_break";
  tree["preset"] = "paper";
  tree["precision"] = "double";
  tree["threads"] = 3;
  tree["real_time_factor"] = 2;
  tree["start_paused"] = true;
  tree["particles_rate_hz"] = 12.5;
  tree["scene_position_m"][0] = 1;
  tree["scene_position_m"][1] = -2.5;
  tree["scene_position_m"][2] = 0;
  const NodeParameters read = readParameters(tree);
  EXPECT_EQ(read.scene, "dam_break");
  EXPECT_EQ(read.preset, "paper");
  EXPECT_EQ(read.precision, Precision::kDouble);
  EXPECT_EQ(read.threads, 3);
  EXPECT_EQ(read.real_time_factor, 2.0);
  EXPECT_TRUE(read.start_paused);
  EXPECT_EQ(read.particles_rate_hz, 12.5);
  EXPECT_EQ(read.scene_position_m, Vec3d(1, -2.5, 0));
}

TEST(Parameters, UnknownNameIsRefusedWithTheOneMeant) {
  const std::string message = refusal(with("particle_rate_hz", 30));
  EXPECT_TRUE(mentions(message, "~particle_rate_hz")) << message;
  EXPECT_TRUE(mentions(message, "did you mean ~particles_rate_hz")) << message;
}

TEST(Parameters, ValueOutOfRangeIsRefusedWithValueAndRange) {
  const std::string message = refusal(with("particles_rate_hz", -3.5));
  EXPECT_TRUE(mentions(message, "~particles_rate_hz")) << message;
  EXPECT_TRUE(mentions(message, "-3.5")) << message;
  EXPECT_TRUE(mentions(message, "[0, 1000]")) << message;
}

TEST(Parameters, WrongTypesAreRefused) {
  EXPECT_TRUE(mentions(refusal(with("threads", 1.5)), "whole number"));
  EXPECT_TRUE(mentions(refusal(with("threads", "two")), "must be a number"));
  EXPECT_TRUE(mentions(refusal(with("start_paused", 1)), "true or false"));
  EXPECT_TRUE(mentions(refusal(with("scene", 4)), "must be a text"));
  EXPECT_TRUE(mentions(refusal(with("scene_rpy_deg", 90)), "three numbers"));
  EXPECT_TRUE(mentions(refusal(with("precision", "half")), "float, double"));
  EXPECT_TRUE(mentions(refusal(with("preset", "fast")), "default, paper"));
  EXPECT_TRUE(mentions(refusal(with("overrides", 3)), "~overrides"));
  EXPECT_TRUE(mentions(refusal(with("real_time_factor", std::nan(""))), "~real_time_factor"));
}

/// roscpp passes `_real_time_factor:=1e1` and `_scene_position_m:=[0,0,1]` as text.
TEST(Parameters, NumbersOfACommandLineAreRead) {
  XmlRpcValue tree;
  tree["real_time_factor"] = "1e1";
  tree["threads"] = "+2";
  tree["scene_position_m"] = "[0,-1.5,1e1]";
  tree["scene_rpy_deg"] = "[ 0, 0 , 90 ]";
  const NodeParameters read = readParameters(tree);
  EXPECT_EQ(read.real_time_factor, 10.0);
  EXPECT_EQ(read.threads, 2);
  EXPECT_EQ(read.scene_position_m, Vec3d(0, -1.5, 10));
  EXPECT_EQ(read.scene_rpy_deg, Vec3d(0, 0, 90));
  for (const char* bad : {"", "[]", "[1, 2]", "[1, 2, 3, 4]", "[1, 2, x]", "1, 2, 3", "[1, 2, ]",
                          "[nan, 0, 0]", "[[1, 2, 3]]", "["}) {
    EXPECT_TRUE(mentions(refusal(with("scene_position_m", bad)), "three numbers")) << bad;
  }
  for (const char* bad : {"", "1 2", "1e", "nan", "inf", "0x10", "1.5.2", "-"}) {
    EXPECT_TRUE(mentions(refusal(with("real_time_factor", bad)), "must be a number")) << bad;
  }
  EXPECT_TRUE(mentions(refusal(with("scene_position_m", "[0, 0, 1e9]")), "1e+09 is outside"));
  EXPECT_TRUE(mentions(refusal(with("threads", "1e300")), "1e+300 is outside"));
  EXPECT_TRUE(mentions(refusal(with("links", 7)), "~links = 7 must be a text; a number as text"));
}

TEST(Parameters, FramesMustBeUsableAndDiffer) {
  EXPECT_TRUE(mentions(refusal(with("frame_id", "")), "~frame_id"));
  for (const std::string& frame :
       {std::string(), std::string("/scene"), std::string("scene/"), std::string("a scene"),
        std::string("sc\ne"), std::string("sc\0ne", 5), std::string(256, 's')}) {
    const std::string message = refusal(with("scene_frame", frame));
    EXPECT_TRUE(mentions(message, "~scene_frame")) << frame;
    EXPECT_TRUE(mentions(message, "no / at either end")) << message;
    EXPECT_LT(message.size(), 400u);
  }
  EXPECT_EQ(refusal(with("scene_frame", std::string(255, 's'))), "");
  EXPECT_TRUE(mentions(refusal(with("scene_frame", "world")), "both world"));
}

TEST(Parameters, TheSceneFrameIsInTheNamespaceOfTheNode) {
  EXPECT_EQ(readParameters(XmlRpcValue()).scene_frame, "ice_ice_baby/scene");
  EXPECT_EQ(readParameters(XmlRpcValue(), "/sim").scene_frame, "ice_ice_baby/scene");
  EXPECT_EQ(readParameters(XmlRpcValue(), "/a/sim").scene_frame, "a/ice_ice_baby/scene");
  EXPECT_EQ(readParameters(XmlRpcValue(), "/a/b/sim").scene_frame, "a/b/ice_ice_baby/scene");
  EXPECT_EQ(readParameters(with("scene_frame", "here"), "/a/sim").scene_frame, "here");
}

TEST(Parameters, HugeBadValuesAreShortenedInMessages) {
  XmlRpcValue list, deep;
  for (int k = 0; k < 20000; ++k) list[k] = 0.5;
  for (int k = 0; k < 900; ++k) {
    XmlRpcValue outer;
    outer[0] = deep;
    deep = outer;
  }
  EXPECT_TRUE(mentions(refusal(list), "must be a map"));
  EXPECT_LT(refusal(list).size(), 400u);
  for (const XmlRpcValue& rubbish : {list, deep, XmlRpcValue(std::string(5000000, 'x'))}) {
    for (const char* name :
         {"scene_position_m", "threads", "start_paused", "precision", "unknown", "overrides"}) {
      const std::string message = refusal(with(name, rubbish));
      EXPECT_TRUE(mentions(message, name)) << name;
      EXPECT_LT(message.size(), 1000u) << name;
    }
  }
}

TEST(Parameters, HugeOverridesAreRefused) {
  XmlRpcValue tree;
  for (int k = 0; k < 60000; ++k) tree["overrides"]["spheres"][k]["radius_m"] = 0.125;
  const std::string message = refusal(tree);
  EXPECT_TRUE(mentions(message, "~overrides holds")) << message;
  EXPECT_TRUE(mentions(message, "[0, 1000000]")) << message;
}

TEST(Parameters, OverridesBecomeDottedKeys) {
  XmlRpcValue tree;
  tree["overrides"]["fluid"]["spacing_m"] = 0.04;
  tree["overrides"]["solver"]["iterations"] = 3;
  tree["overrides"]["preset"] = "paper";
  tree["overrides"]["gravity_m_s2"][0] = 0;
  tree["overrides"]["gravity_m_s2"][1] = 0.5;
  tree["overrides"]["gravity_m_s2"][2] = -1;
  std::ostringstream found;
  for (const Override& change : readParameters(tree).overrides) {
    found << change.key << "=" << change.value << ";";
  }
  EXPECT_EQ(found.str(),
            "fluid.spacing_m=0.04;gravity_m_s2=[0, 0.5, -1];preset=\"paper\";"
            "solver.iterations=3;");
}

TEST(Parameters, OverridesReachTheScene) {
  XmlRpcValue tree;
  tree["overrides"]["fluid"]["spacing_m"] = 0.04;
  tree["overrides"]["spheres"][0]["name"] = "ball\"\\";
  tree["overrides"]["description"] = "a \"quoted\"\n line";
  const Scene scene = parseScene("{}", readParameters(tree).overrides);
  EXPECT_EQ(scene.fluid.spacing_m, 0.04);
  ASSERT_EQ(scene.spheres.size(), 1u);
  EXPECT_EQ(scene.spheres[0].name, "ball\"\\");
  EXPECT_EQ(scene.description, "a \"quoted\"\n line");
}

TEST(Parameters, PresetOfTheNodeIsAnOverride) {
  NodeParameters parameters;
  EXPECT_TRUE(overridesFor(parameters, "").empty());
  EXPECT_EQ(parseScene("{}", overridesFor(parameters, "paper")).preset, Preset::kPaper);
}

TEST(Parameters, DocumentListsEachAsItIs) {
  std::ifstream stream(IIB_ROS_INTERFACE);
  std::stringstream document;
  document << stream.rdbuf();
  std::istringstream table(parameterTable());
  for (std::string row; std::getline(table, row);) {
    EXPECT_TRUE(mentions(document.str(), row)) << "doc/ros_interface.md lacks the row\n" << row;
  }
}

}  // namespace
}  // namespace ice_ice_baby
