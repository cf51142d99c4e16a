#include "progress_bar.h"

#include <unistd.h>

#include <cstdio>

namespace ice_ice_baby {

ProgressBar::ProgressBar(std::string title, std::size_t total)
    : title_(std::move(title)),
      total_(total),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()) {}

ProgressBar::~ProgressBar() {
  if (terminal_) std::fprintf(stderr, "\r\033[K");
}

void ProgressBar::show(std::size_t done, const std::string& note) {
  const Clock::time_point now = Clock::now();
  if (!terminal_ || total_ == 0) return;
  if (now - shown_ < std::chrono::milliseconds(100) && done != total_) return;
  shown_ = now;
  constexpr std::size_t kBarWidth = 30;
  const std::size_t filled = kBarWidth * done / total_;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = done > 0 ? elapsed * double(total_ - done) / double(done) : 0.0;
  std::fprintf(stderr, "\r\033[K%s %3zu%%|%s%s| %zu/%zu [%.0fs<%.0fs] %s", title_.c_str(),
               100 * done / total_, std::string(filled, '#').c_str(),
               std::string(kBarWidth - filled, ' ').c_str(), done, total_, elapsed, left,
               note.c_str());
  std::fflush(stderr);
}

}  // namespace ice_ice_baby
