// Tells ThreadSanitizer about the ordering of a parallel loop.
#pragma once

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define IIB_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif
#endif

namespace ice_ice_baby {

/// Every range runs after the fork and before the join. Debian's oneTBB is not compiled for
/// ThreadSanitizer, so without these annotations every loop would be reported as a race. Ranges
/// stay unordered among themselves, so races between them are still found. Empty in every other
/// build.
class ForkJoin {
 public:
#ifdef IIB_THREAD_SANITIZER
  ForkJoin() { __tsan_release(&forked_); }
  void beginRange() { __tsan_acquire(&forked_); }
  void endRange() { __tsan_release(&ended_); }
  void join() { __tsan_acquire(&ended_); }

 private:
  char forked_ = 0, ended_ = 0;
#else
  void beginRange() {}
  void endRange() {}
  void join() {}
#endif
};

}  // namespace ice_ice_baby
