#include <XmlRpcException.h>

#include "ice_ice_baby/errors.h"
#include "parameters.h"
#include "promises.h"

namespace ice_ice_baby::fuzz {

void parameterTree(const std::string& bytes) {
  int offset = 0;
  XmlRpc::XmlRpcValue tree;
  // Input that roscpp cannot parse never reaches the node.
  if (!tree.fromXml(bytes, &offset)) return;
  try {
    const NodeParameters parameters = readParameters(tree);
    const std::string scene = "fluid: {spacing_m: 0.05}\nblocks: [{max_m: [0.1, 0.1, 0.1]}]";
    runIfSmall(parseScene(scene, overridesFor(parameters, parameters.preset), "fuzz.yaml"));
  } catch (const InvalidInput& e) {
    requireReadable(e.what());
  }
}

}  // namespace ice_ice_baby::fuzz
