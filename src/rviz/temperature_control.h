// Slider for the temperature to reach, time of the ramp, and the current temperature.
#pragma once

#include <QStringList>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace ice_ice_baby {

/// Requests a temperature when the slider comes to rest: in [-30, 40] degrees C, in a thermal scene
/// up to 150, and there also of a chosen collider.
class TemperatureControl : public QWidget {
  Q_OBJECT

 public:
  explicit TemperatureControl(QWidget* parent = nullptr);

  /// Moves the slider to the temperature of the scene or its air without requesting anything. While
  /// a collider is chosen the slider stays, because its temperature is not known.
  void showTarget(double celsius);

  /// Shows the present temperature; NaN: unknown. @param mean_c mean of the particles; NaN: none
  void showInForce(double celsius, double mean_c);

  /// Offers the air and these colliders; hidden if the scene is not thermal.
  void offerTargets(bool thermal, const QStringList& colliders);

  double ramp() const;  ///< s
  void setRamp(double seconds);

 Q_SIGNALS:
  /// @param collider its name, "": the scene or its air
  void requested(double celsius, double ramp_s, const QString& collider);
  void rampChanged();

 private:
  void layOut();
  void readOutTarget(int celsius);
  void setWarmest(int celsius);
  QString collider() const;

  QSlider* slider_;
  QLabel* target_;
  QLabel* in_force_;
  QLabel* of_;
  QComboBox* choice_;  ///< air and colliders; hidden if the scene is not thermal
  QDoubleSpinBox* ramp_;
  QTimer at_rest_;  ///< combines many small moves into one request
};

}  // namespace ice_ice_baby
