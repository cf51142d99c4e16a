#include "ice_ice_baby/errors.h"
#include "loading/mesh_reader.h"

namespace ice_ice_baby {

TriangleMesh readMesh(const std::string&, const std::string&) {
  throw InvalidInput(
      "cannot be read, because this program was built without libassimp-dev; install it and build "
      "again");
}

}  // namespace ice_ice_baby
