// Writes files atomically: to a temporary file, flushed to disk, then renamed.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "ice_ice_baby/checkpoint.h"
#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace fs = std::filesystem;

namespace {

/// Text of errno after a failed system call.
struct SystemError {
  int number;
};

void require(bool worked) {
  if (!worked) throw SystemError{errno};
}

/// Owns the descriptor of an open file or folder.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : number_(::open(path.c_str(), flags, 0666)) {
    require(number_ >= 0);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { ::close(number_); }

  operator int() const { return number_; }

 private:
  int number_;
};

/// Waits for the lock of the file. @return whether the file is still at `path` afterwards
bool lock(const Descriptor& file, const fs::path& path) {
  while (::flock(file, LOCK_EX) != 0) require(errno == EINTR);
  struct stat opened {
  }, there{};
  require(::fstat(file, &opened) == 0);
  return ::stat(path.c_str(), &there) == 0 && there.st_ino == opened.st_ino;
}

void writeAll(const Descriptor& file, std::string_view bytes) {
  require(::ftruncate(file, 0) == 0);
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    require(written >= 0 || errno == EINTR);
    if (written > 0) bytes.remove_prefix(std::size_t(written));
  }
  require(::fsync(file) == 0);
}

/// @return false when another process was faster; the caller must try again
bool replace(const fs::path& target, const fs::path& part, std::string_view bytes) {
  const Descriptor file(part, O_WRONLY | O_CREAT | O_CLOEXEC);
  if (!lock(file, part)) return false;
  try {
    writeAll(file, bytes);
    require(::rename(part.c_str(), target.c_str()) == 0);
  } catch (const SystemError&) {
    ::unlink(part.c_str());
    throw;
  }
  const Descriptor folder(target.parent_path(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  require(::fsync(folder) == 0 || errno == EINVAL);  // some file systems cannot sync a folder
  return true;
}

/// Resolves links, and refuses devices.
fs::path targetOf(const std::string& path) {
  std::error_code error;
  const fs::path absolute = path.empty() ? fs::path() : fs::absolute(path, error);
  fs::path target = fs::weakly_canonical(absolute, error);
  if (error || path.empty() || (fs::exists(target) && !fs::is_regular_file(target))) {
    throw InvalidInput("cannot save the checkpoint to \"" + path +
                       "\": that is not a file; name one, as run.ckpt");
  }
  return target;
}

InvalidInput refusal(const std::string& path, const SystemError& error) {
  return InvalidInput("cannot save the checkpoint to " + path + ": " + std::strerror(error.number) +
                      "; what was there is unchanged. Make room or choose another place");
}

}  // namespace

void requireSavable(const std::string& path) {
  const fs::path target = targetOf(path);
  if (::access(target.parent_path().c_str(), W_OK) != 0) throw refusal(path, {errno});
}

void writeCheckpoint(std::string_view bytes, const std::string& path) {
  const fs::path target = targetOf(path);
  // A fixed name, so that the next save overwrites what a killed process left behind.
  const fs::path part = target.string() + ".part";
  try {
    while (!replace(target, part, bytes)) continue;
  } catch (const SystemError& e) {
    throw refusal(path, e);
  }
}

std::unique_ptr<Simulation> loadCheckpoint(const std::string& path, int threads) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) throw InvalidInput("no checkpoint " + path);
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(std::size_t(fs::file_size(path, error)), '\0');
  if (!stream.read(bytes.data(), std::streamsize(bytes.size()))) {
    throw InvalidInput("cannot read checkpoint " + path + "; is it readable for you?");
  }
  return decodeCheckpoint(bytes, path, threads);
}

}  // namespace ice_ice_baby
