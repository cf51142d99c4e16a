// Slider for the temperature to reach, time to get there, and the temperature in force.
#pragma once

#include <QTimer>
#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace ice_ice_baby {

/// Asks for a temperature in [-30, 40] degrees C when the slider comes to rest.
class TemperatureControl : public QWidget {
  Q_OBJECT

 public:
  explicit TemperatureControl(QWidget* parent = nullptr);

  /// Puts the slider somewhere without asking for anything.
  void showTarget(double celsius);

  /// Shows what the simulation has now; NaN: unknown.
  void showInForce(double celsius);

  double ramp() const;  ///< s
  void setRamp(double seconds);

 Q_SIGNALS:
  void requested(double celsius, double ramp_s);
  void rampChanged();

 private:
  void readOutTarget(int celsius);

  QSlider* slider_;
  QLabel* target_;
  QLabel* in_force_;
  QDoubleSpinBox* ramp_;
  QTimer at_rest_;  ///< gathers the wheel's and the keys' many small moves into one request
};

}  // namespace ice_ice_baby
