// Handles SIGINT and SIGTERM as a request to stop after the present frame.
#pragma once

namespace ice_ice_baby {

/// While an instance exists, the first of these signals is recorded and a second one ends the
/// program as usual. At most one instance may exist.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  bool raised() const;
};

}  // namespace ice_ice_baby
