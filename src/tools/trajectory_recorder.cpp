#include "trajectory_recorder.h"

#include <limits>

#include "ice_ice_baby/errors.h"

namespace ice_ice_baby {

namespace {

/// NumPy aligns the data to 64 bytes; 128 bytes leave room for any shape.
constexpr std::size_t kHeader_bytes = 128;

}  // namespace

TrajectoryRecorder::TrajectoryRecorder(std::string path, std::size_t particles)
    : path_(std::move(path)), file_(path_, std::ios::binary), particles_(particles) {
  writeHeader();
}

void TrajectoryRecorder::add(const FrameView& frame) {
  if (frames_ == 0) {
    for (const ParticleSample& p : frame.particles) ids_.push_back(p.id);
  }
  std::vector<float> row(3 * particles_, std::numeric_limits<float>::quiet_NaN());
  std::size_t column = 0;
  for (const ParticleSample& p : frame.particles) {
    while (ids_[column] != p.id) ++column;
    row[3 * column] = p.x;
    row[3 * column + 1] = p.y;
    row[3 * column + 2] = p.z;
  }
  file_.write(reinterpret_cast<const char*>(row.data()),
              std::streamsize(row.size() * sizeof(float)));
  ++frames_;
  writeHeader();
}

/// Rewrites the header after every frame, so that the file of an interrupted run can be read.
void TrajectoryRecorder::writeHeader() {
  std::string header("\x93NUMPY\x01\x00", 8);
  const std::size_t length = kHeader_bytes - 10;
  header += char(length % 256);
  header += char(length / 256);
  header += "{'descr': '<f4', 'fortran_order': False, 'shape': (" + std::to_string(frames_) + ", " +
            std::to_string(particles_) + ", 3), }";
  header.resize(kHeader_bytes - 1, ' ');
  header += '\n';
  file_.seekp(0);
  file_.write(header.data(), std::streamsize(header.size()));
  file_.seekp(0, std::ios::end);
  file_.flush();
  if (!file_) throw InvalidInput("cannot write the record to " + path_);
}

}  // namespace ice_ice_baby
