#include "loading/in_own_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

constexpr char kAnswer = 'a', kRefusal = 'r';

/// Memory that the function may use on top of what the program has.
constexpr rlim_t kMemory_bytes = rlim_t(4) << 30;

/// Of this process, with what it has reserved and never used.
rlim_t addressSpace_bytes() {
  std::ifstream statm("/proc/self/statm");
  rlim_t pages = 0;
  statm >> pages;
  return pages * rlim_t(sysconf(_SC_PAGESIZE));
}

void writeAll(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t wrote = write(file, text.data() + done, text.size() - done);
    if (wrote < 0 && errno != EINTR) return;
    if (wrote > 0) done += std::size_t(wrote);
  }
}

std::string readAll(int file) {
  std::string text;
  char buffer[65536];
  for (;;) {
    const ssize_t got = read(file, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(buffer, std::size_t(got));
  }
}

[[noreturn]] void runChild(const std::function<std::string()>& function, int answer, int limit_s) {
  const rlimit time{rlim_t(limit_s), rlim_t(limit_s)}, no_core{0, 0};
  const rlimit memory{addressSpace_bytes() + kMemory_bytes, addressSpace_bytes() + kMemory_bytes};
  setrlimit(RLIMIT_CPU, &time);
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_AS, &memory);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  std::string text;
  try {
    text = kAnswer + function();
  } catch (const std::exception& e) {
    text = kRefusal + std::string(e.what());
  }
  writeAll(answer, text);
  _exit(0);
}

}  // namespace

std::string inOwnProcess(const std::function<std::string()>& function, int limit_s) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw InvalidInput(std::string("cannot be read, as no pipe can be made: ") +
                       std::strerror(errno));
  }
  const pid_t child = fork();
  if (child == 0) runChild(function, ends[1], limit_s);
  close(ends[1]);
  const std::string text = child > 0 ? readAll(ends[0]) : "";
  close(ends[0]);
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!text.empty() && text[0] == kAnswer) return text.substr(1);
  if (!text.empty()) throw InvalidInput(text.substr(1));
  const bool slow = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
  throw InvalidInput(slow ? "takes longer than " + std::to_string(limit_s) + " s to read"
                          : std::string("is damaged: the program that reads it crashed"));
}

}  // namespace ice_ice_baby
