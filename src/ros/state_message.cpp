#include "state_message.h"

#include <type_traits>
#include <utility>

#include "geometry.h"
#include "parameters.h"

namespace ice_ice_baby {

namespace {

template <class Choice>
std::string choiceName(Choice choice) {
  return choices(choice)[static_cast<std::size_t>(choice)];
}

/// The message with a member for every name that the report describes.
struct NamedAsReport : State {
  double& temperature_c = temperature;
  double& mean_celsius = mean_temperature;
};

}  // namespace

State stateMessage(const Snapshot& snapshot, const std_msgs::Header& header) {
  NamedAsReport state;
  const auto carry = [](const char*, const auto& reported, auto& field, const char*) {
    field = static_cast<std::decay_t<decltype(field)>>(reported);
  };
  describeAll(carry, snapshot.report, state);
  state.header = header;
  state.scene = snapshot.scene;
  state.preset = choiceName(snapshot.preset);
  state.precision = choiceName(snapshot.precision);
  state.paused = snapshot.paused;
  state.state_hash = snapshot.state_hash;
  state.spacing_m = snapshot.spacing_m;
  if (!snapshot.view.isEmpty()) {
    state.view_low = pointMessage(snapshot.view.min());
    state.view_high = pointMessage(snapshot.view.max());
  }
  state.thermal = snapshot.thermal;
  if (snapshot.thermal) state.targets = snapshot.colliders;
  state.gravity = vectorMessage(snapshot.gravity_m_s2);
  state.real_time_factor = snapshot.real_time_factor;
  for (const StageStats& stage : snapshot.stages) {
    StageCost cost;
    cost.name = stage.name;
    cost.calls = stage.calls;
    cost.time_s = stage.time_s;
    cost.bytes = stage.bytes;
    state.stages.push_back(cost);
  }
  return std::move(static_cast<State&>(state));
}

}  // namespace ice_ice_baby
