#include "scene_loading.h"

#include "answer.h"
#include "ice_ice_baby/errors.h"
#include "requests.h"
#include "served_scene.h"

namespace ice_ice_baby {

SceneLoading::SceneLoading(ros::NodeHandle node, const NodeParameters& parameters,
                           SimulationThread& simulation)
    : parameters_(parameters), simulation_(simulation), spinner_(1, &queue_) {
  node.setCallbackQueue(&queue_);
  server_ = node.advertiseService("load_scene", &SceneLoading::loadScene, this);
  spinner_.start();
}

bool SceneLoading::loadScene(LoadScene::Request& request, LoadScene::Response& response) {
  response.particles = static_cast<std::uint32_t>(simulation_.snapshot().report.particles);
  return answer(response, [&] {
    const ServedScene served = sceneFor(request);
    std::unique_ptr<Simulation> made =
        makeSimulation(served.scene, parameters_.precision, parameters_.threads);
    const auto particles = static_cast<std::uint32_t>(made->report().particles);
    simulation_.load(std::move(made), served);
    response.particles = particles;
    return "scene " + served.scene.name + " from the start";
  });
}

ServedScene SceneLoading::sceneFor(const LoadScene::Request& request) const {
  if (request.scene.empty() == request.yaml.empty()) {
    throw InvalidInput(request.scene.empty()
                           ? "scene and yaml are both empty; give the name of a scene, or its text"
                           : "scene = \"" + shortened(request.scene) +
                                 "\" and yaml are both given; leave one of them empty");
  }
  if (!request.yaml.empty()) return parseServedScene(parameters_, request.yaml);
  requireSceneName(request.scene);
  return {loadServedScene(parameters_, request.scene, parameters_.preset), request.scene};
}

}  // namespace ice_ice_baby
