// A line of text in a picture.
#pragma once

#include <string>

#include "pictures/canvas.h"

namespace ice_ice_baby {

/// Draws small letters, digits and . - % _ before everything else; '^' is a degree sign, anything
/// else a gap. @param dot pixels of the picture that a dot of a letter is wide; 7 dots are a line
void drawText(Canvas& canvas, int left, int top, int dot, const std::string& text, Colour colour);

}  // namespace ice_ice_baby
