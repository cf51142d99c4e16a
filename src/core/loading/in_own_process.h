// Runs a function whose crash must not end the program.
#pragma once

#include <functional>
#include <string>

namespace ice_ice_baby {

/// Runs a function in a copy of this process and returns what it returned. What it prints is lost.
/// @param limit_s processor time that it may use
/// @throws InvalidInput with the message of an InvalidInput that it threw, or that it crashed or
///   took too long
std::string inOwnProcess(const std::function<std::string()>& function, int limit_s);

}  // namespace ice_ice_baby
