// The order that a parallel loop promises, told to ThreadSanitizer.
#pragma once

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define IIB_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif
#endif

namespace ice_ice_baby {

/// Every range runs after the fork and before the join. oneTBB's library sees to it by means that
/// ThreadSanitizer cannot follow, as Debian's is not compiled for it; without this every loop
/// would be a race. Ranges stay unordered among themselves, so that their races are still found.
/// Empty in every other build.
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
