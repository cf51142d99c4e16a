#include "pictures/caption.h"

#include <algorithm>
#include <cstdint>

namespace ice_ice_baby {

namespace {

constexpr int kWide = 5;
constexpr int kHigh = 7;

/// Five dots by seven, row by row from the highest bit.
struct Glyph {
  char letter;
  std::uint64_t dots;
};
constexpr Glyph kGlyphs[] = {
    {'0', 0x3a33ae62e}, {'1', 0x11842108e}, {'2', 0x3a211111f}, {'3', 0x7c441062e},
    {'4', 0x08ca97c42}, {'5', 0x7e1e0862e}, {'6', 0x1910f462e}, {'7', 0x7c2222108},
    {'8', 0x3a317462e}, {'9', 0x3a317844c}, {'.', 0x00000018c}, {',', 0x000003088},
    {'-', 0x000070000}, {'%', 0x632222263}, {'_', 0x00000001f}, {'^', 0x325260000},
    {'C', 0x3a308422e}, {'a', 0x000e0be2f}, {'b', 0x4216cc63e}, {'c', 0x000e8422e},
    {'d', 0x042d9c62f}, {'e', 0x000e8fe0e}, {'f', 0x1928e2108}, {'g', 0x01f18bc2e},
    {'h', 0x4216cc631}, {'i', 0x100c2108e}, {'j', 0x080610a4c}, {'k', 0x4212a6292},
    {'l', 0x30842108e}, {'m', 0x001aad631}, {'n', 0x0016cc631}, {'o', 0x000e8c62e},
    {'p', 0x001e8fa10}, {'q', 0x000d9bc21}, {'r', 0x0016cc210}, {'s', 0x000e8383e},
    {'t', 0x211c42126}, {'u', 0x00118c66d}, {'v', 0x00118c544}, {'w', 0x00118d6aa},
    {'x', 0x001151151}, {'y', 0x00118bc2e}, {'z', 0x001f1111f},
};

}  // namespace

void drawText(Canvas& canvas, int left, int top, int dot, const std::string& text, Colour colour) {
  for (const char letter : text) {
    const auto* glyph = std::find_if(std::begin(kGlyphs), std::end(kGlyphs),
                                     [&](const Glyph& g) { return g.letter == letter; });
    const std::uint64_t dots = glyph == std::end(kGlyphs) ? 0 : glyph->dots;
    for (int y = 0; y < kHigh * dot; ++y) {
      for (int x = 0; x < kWide * dot; ++x) {
        const int bit = kWide * kHigh - 1 - (y / dot * kWide + x / dot);
        if (dots >> bit & 1) canvas.blend(left + x, top + y, 0.0f, colour, 1.0f);
      }
    }
    left += (kWide + 1) * dot;
  }
}

}  // namespace ice_ice_baby
