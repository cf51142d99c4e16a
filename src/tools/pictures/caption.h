// A line of text in a picture.
#pragma once

#include <string>

#include "pictures/canvas.h"

namespace ice_ice_baby {

/// Draws small letters, digits and . - % _ in front of everything else. '^' is a degree sign, any
/// other character a space. @param dot width of a dot of a letter in pixels; 7 dots are a line
void drawText(Canvas& canvas, int left, int top, int dot, const std::string& text, Colour colour);

}  // namespace ice_ice_baby
