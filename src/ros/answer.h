// How every service answers: success, or why not.
#pragma once

#include <exception>

namespace ice_ice_baby {

/// Runs `work` and answers with what it returns, or with why it was refused.
template <class Response, class Work>
bool answer(Response& response, const Work& work) {
  try {
    response.message = work();
    response.success = true;
  } catch (const std::exception& e) {
    response.message = e.what();
    response.success = false;
  }
  return true;
}

}  // namespace ice_ice_baby
