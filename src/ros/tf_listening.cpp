#include "tf_listening.h"

#include <ros/master.h>

#include <chrono>
#include <utility>

#include "tf_feed.h"
#include "tf_watch.h"

namespace ice_ice_baby {

namespace {

/// Interval between checks whether the master answers again.
constexpr std::chrono::milliseconds kLook{500};

}  // namespace

struct TfListening::Listener {
  explicit Listener(const TfListening& of)
      : feed(of.node_, of.buffer_, of.own_, watch, of.arrived_) {}

  TfWatch watch;
  TfFeed feed;
};

TfListening::TfListening(const ros::NodeHandle& node, tf2_ros::Buffer& buffer, const OwnFrames& own,
                         std::function<void()> arrived)
    : node_(node), buffer_(buffer), own_(own), arrived_(std::move(arrived)), thread_([this] {
        run();
      }) {}

TfListening::~TfListening() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void TfListening::want(bool wanted) {
  const std::lock_guard<std::mutex> lock(mutex_);
  wanted_ = wanted;
  changed_.notify_all();
}

std::vector<std::string> TfListening::refused() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return listener_ ? listener_->watch.refused() : std::vector<std::string>();
}

void TfListening::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || wanted_ != bool(listener_); });
    if (stopping_) return;
    std::unique_ptr<Listener> other = std::move(listener_);
    const bool begin = wanted_;
    lock.unlock();
    other.reset();
    // Checked first, because roscpp holds the locks of all topics while it waits for the master.
    if (begin && ros::master::check()) other = std::make_unique<Listener>(*this);
    lock.lock();
    listener_ = std::move(other);
    if (begin && !listener_) changed_.wait_for(lock, kLook, [this] { return stopping_; });
  }
}

}  // namespace ice_ice_baby
