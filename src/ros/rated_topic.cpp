#include "rated_topic.h"

namespace ice_ice_baby {

bool RatedTopic::due(bool news, bool last, bool repeat) {
  if (!subscribed()) return false;
  const bool urgent = new_subscriber_.exchange(false) || (news && last);
  const WallClock::time_point now = WallClock::now();
  const bool old = repeat && now - gate_.latest() > std::chrono::seconds(1);
  if (!news && !urgent && !old) return false;
  return gate_.pass(now, urgent);
}

TopicLoad RatedTopic::load() const {
  TopicLoad load;
  load.name = publisher_.getTopic();
  load.subscribers = publisher_.getNumSubscribers();
  load.messages = messages_;
  load.bytes = bytes_;
  return load;
}

}  // namespace ice_ice_baby
