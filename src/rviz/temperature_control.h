// Slider for the temperature to reach, time to get there, and the temperature in force.
#pragma once

#include <QStringList>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace ice_ice_baby {

/// Asks for a temperature when the slider comes to rest: of [-30, 40] degrees C, with heat up to
/// 150, and then also of a chosen collider.
class TemperatureControl : public QWidget {
  Q_OBJECT

 public:
  explicit TemperatureControl(QWidget* parent = nullptr);

  /// Puts the slider to the temperature of the scene or its air without asking for anything. While
  /// a collider is chosen, the slider stays: nobody tells how warm that is.
  void showTarget(double celsius);

  /// Shows what the simulation has now, NaN: unknown. @param mean_c over the particles, NaN: none
  void showInForce(double celsius, double mean_c);

  /// Offers the air and these colliders; without heat no choice is shown.
  void offerTargets(bool heat, const QStringList& colliders);

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
  QComboBox* choice_;  ///< of air and colliders; hidden without heat
  QDoubleSpinBox* ramp_;
  QTimer at_rest_;  ///< gathers the wheel's and the keys' many small moves into one request
};

}  // namespace ice_ice_baby
