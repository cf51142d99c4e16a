// Martin and Moyce 1952: the front of a collapsing water column, measured.
#pragma once

#include <vector>

namespace ice_ice_baby {

/// Their columns are twice as high as they are wide (n^2 = 2). With a the width of the column,
/// time is T = t sqrt(2 g / a), and the front X is its distance from the wall behind in units of a.
struct FrontPoint {
  double time;   ///< T
  double front;  ///< X
};

/// The two columns that they let go, a = 2.25 and 1.125 inches. In the smaller one the film on the
/// floor holds the water back more.
const std::vector<FrontPoint>& martinMoyceWide();
const std::vector<FrontPoint>& martinMoyceNarrow();

/// Root mean square of (X - X_measured) / X_measured over the points with T from 1.2 to 4: earlier,
/// how fast the real gate opened decides, later, where the tank of a scene ends.
/// @param run in order of time; straight lines between its points
/// @return NaN when `run` does not reach T = 4
double frontError(const std::vector<FrontPoint>& run, const std::vector<FrontPoint>& measured);

}  // namespace ice_ice_baby
