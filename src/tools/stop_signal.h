// SIGINT and SIGTERM as a wish to end after the present frame.
#pragma once

namespace ice_ice_baby {

/// While it lives, the first of these signals is noted and a second one ends the program as usual.
/// One at a time.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  bool raised() const;
};

}  // namespace ice_ice_baby
