#include "publisher_thread.h"

#include <ros/console.h>

#include <algorithm>

namespace ice_ice_baby {

PublisherThread::PublisherThread(std::vector<std::function<void()>> tasks)
    : tasks_(std::move(tasks)), busy_(tasks_.size(), false), thread_([this] { run(); }) {}

PublisherThread::~PublisherThread() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

bool PublisherThread::busy(std::size_t topic) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return busy_[topic];
}

void PublisherThread::request(std::size_t topic) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    busy_[topic] = true;
  }
  changed_.notify_one();
}

/// Goes over all topics in turn, so that a frequent one does not hold up the others.
void PublisherThread::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] {
      return stopping_ || std::find(busy_.begin(), busy_.end(), true) != busy_.end();
    });
    for (std::size_t topic = 0; topic < tasks_.size() && !stopping_; ++topic) {
      if (!busy_[topic]) continue;
      lock.unlock();
      runTask(topic);
      lock.lock();
      busy_[topic] = false;
    }
    if (stopping_) return;
  }
}

void PublisherThread::runTask(std::size_t topic) {
  try {
    tasks_[topic]();
  } catch (const std::exception& e) {
    if (!log_gate_.pass(WallClock::now(), false)) return;
    ROS_ERROR("A message was dropped, the simulation goes on: %s", e.what());
  }
}

}  // namespace ice_ice_baby
