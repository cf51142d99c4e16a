// The answer of a service: success, or the reason for a refusal.
#pragma once

#include <exception>

namespace ice_ice_baby {

/// Runs `work`. The message is what it returns, or the text of the exception it throws.
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
