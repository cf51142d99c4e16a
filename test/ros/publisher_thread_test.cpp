// Snapshots handed from one thread to another: one at a time per topic, in order, nobody waits.
#include "publisher_thread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>

namespace ice_ice_baby {
namespace {

using std::chrono::milliseconds;

bool becomesFree(const PublisherThread& publisher, std::size_t topic) {
  for (int k = 0; k < 5000; ++k) {
    if (!publisher.busy(topic)) return true;
    std::this_thread::sleep_for(milliseconds(2));
  }
  return false;
}

TEST(PublisherThreads, RunARequestedTaskOnceOnAnotherThread) {
  int runs[] = {0, 0};
  std::thread::id ran_on;
  PublisherThread publisher({[&] { ++runs[0]; },
                             [&] {
                               ++runs[1];
                               ran_on = std::this_thread::get_id();
                             }});
  EXPECT_FALSE(publisher.busy(0));
  publisher.request(1);
  ASSERT_TRUE(becomesFree(publisher, 1));
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_EQ(runs[0], 0);
  EXPECT_EQ(runs[1], 1);
  EXPECT_NE(ran_on, std::this_thread::get_id());
}

TEST(PublisherThreads, SlowTaskDelaysNeitherTheCallerNorAnyRequestForLong) {
  std::atomic<bool> held{true};
  std::atomic<int> others{0};
  PublisherThread publisher({[&] {
                               while (held) std::this_thread::sleep_for(milliseconds(1));
                             },
                             [&] { ++others; }});
  const auto start = std::chrono::steady_clock::now();
  publisher.request(0);
  publisher.request(1);
  EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(500));
  std::this_thread::sleep_for(milliseconds(50));
  EXPECT_TRUE(publisher.busy(0));  // so the caller takes no further snapshot of it
  held = false;
  EXPECT_TRUE(becomesFree(publisher, 0));
  EXPECT_TRUE(becomesFree(publisher, 1));
  EXPECT_EQ(others, 1);
}

TEST(PublisherThreads, SnapshotsArriveWholeAndInOrder) {
  std::vector<int> snapshot;
  std::vector<int> seen;
  bool whole = true;
  int taken = 0;
  {
    PublisherThread publisher({[&] {
      for (const int value : snapshot) whole = whole && value == snapshot[0];
      seen.push_back(snapshot[0]);
    }});
    for (int frame = 0; taken < 200; ++frame) {
      std::this_thread::yield();
      if (publisher.busy(0)) continue;  // this frame is skipped
      snapshot.assign(100, frame);
      ++taken;
      publisher.request(0);
    }
    ASSERT_TRUE(becomesFree(publisher, 0));
  }
  EXPECT_TRUE(whole);
  EXPECT_EQ(int(seen.size()), taken);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
}

TEST(PublisherThreads, TaskThatThrowsFreesItsTopic) {
  bool fails = true;
  int runs = 0;
  PublisherThread publisher({[&] {
    if (fails) throw std::runtime_error("no memory");
    ++runs;
  }});
  publisher.request(0);
  ASSERT_TRUE(becomesFree(publisher, 0));
  fails = false;
  publisher.request(0);
  ASSERT_TRUE(becomesFree(publisher, 0));
  EXPECT_EQ(runs, 1);
}

TEST(PublisherThreads, EndWaitsForTheRunningTaskAndDropsTheRest) {
  std::atomic<bool> running{false}, ended{false};
  std::atomic<int> dropped_runs{0};
  {
    PublisherThread publisher({[&] {
                                 running = true;
                                 std::this_thread::sleep_for(milliseconds(50));
                                 ended = true;
                               },
                               [&] { ++dropped_runs; }});
    publisher.request(0);
    while (!running) std::this_thread::sleep_for(milliseconds(1));
    publisher.request(1);
  }
  EXPECT_TRUE(ended);
  EXPECT_EQ(dropped_runs, 0);
}

}  // namespace
}  // namespace ice_ice_baby
