// Text of numbers where the standard library has none, against std::to_chars where it has.
#include "base/shortest_text.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <random>

namespace ice_ice_baby {
namespace shortest_text_test {

template <class Real>
void expectSameText(Real value) {
  EXPECT_EQ(shortestTextByStreams(value), shortestText(value));
}

TEST(ShortestText, StreamsWriteWhatToCharsWrites) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double value : {0.0,
                             -0.0,
                             0.1,
                             1.0 / 3,
                             20.0,
                             -20.0,
                             1000.0,
                             12345.678,
                             99999.0,
                             1e5,
                             1e6,
                             123456789.0,
                             1e22,
                             1e-3,
                             1e-4,
                             1.5e-4,
                             1e-6,
                             -273.15,
                             5e-324,
                             1.7976931348623157e308,
                             inf,
                             -inf,
                             std::numeric_limits<double>::quiet_NaN()}) {
    expectSameText(value);
    expectSameText(static_cast<float>(value));
  }
  EXPECT_EQ(shortestTextByStreams(0.1f), "0.1");
  EXPECT_EQ(shortestTextByStreams(1e-6), "1e-06");
}

TEST(ShortestText, StreamsWriteWhatReadsBackAsTheSameNumber) {
  std::mt19937 random(7);
  for (int k = 0; k < 2000; ++k) {
    const auto bits = static_cast<std::uint32_t>(random());
    float value;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(std::strtof(shortestTextByStreams(value).c_str(), nullptr), value);
    EXPECT_LE(shortestTextByStreams(value).size(), shortestText(value).size());
  }
}

}  // namespace shortest_text_test
}  // namespace ice_ice_baby
