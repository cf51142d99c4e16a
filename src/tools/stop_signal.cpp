#include "stop_signal.h"

#include <csignal>
#include <initializer_list>

namespace ice_ice_baby {

namespace {

volatile std::sig_atomic_t noted = 0;

void note(int number) {
  noted = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

StopSignal::StopSignal() {
  noted = 0;
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, note);
}

StopSignal::~StopSignal() {
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
}

bool StopSignal::raised() const { return noted != 0; }

}  // namespace ice_ice_baby
