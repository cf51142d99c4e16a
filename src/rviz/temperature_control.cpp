#include "temperature_control.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

namespace ice_ice_baby {
namespace {

constexpr int COLDEST_C = -30;
constexpr int WARMEST_C = 40;
constexpr int AT_REST_MS = 150;

const char* const SLIDER_STYLE =
    "QSlider::groove:horizontal { height: 8px; border-radius: 4px; background: qlineargradient("
    "x1:0, y1:0, x2:1, y2:0, stop:0 #eef6fb, stop:0.42 #7fb6de, stop:0.45 #2f7dc0, stop:1 #d4694a);"
    "}"
    "QSlider::handle:horizontal { width: 14px; margin: -5px 0; border-radius: 7px;"
    " background: #ffffff; border: 2px solid #3a4a58; }";

}  // namespace

TemperatureControl::TemperatureControl(QWidget* parent)
    : QWidget(parent),
      slider_(new QSlider(Qt::Horizontal)),
      target_(new QLabel),
      in_force_(new QLabel),
      ramp_(new QDoubleSpinBox) {
  slider_->setObjectName("temperature_slider");
  slider_->setRange(COLDEST_C, WARMEST_C);
  slider_->setTracking(false);
  slider_->setStyleSheet(SLIDER_STYLE);
  slider_->setToolTip("Temperature to reach. Water freezes below 0 °C.");
  in_force_->setObjectName("temperature_in_force");
  in_force_->setAlignment(Qt::AlignRight);
  ramp_->setObjectName("ramp");
  ramp_->setRange(0.0, 600.0);
  ramp_->setDecimals(1);
  ramp_->setSuffix(" s");
  ramp_->setToolTip("Simulated time in which the temperature gets there. 0: at once.");

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(target_, 0, 0);
  grid->addWidget(in_force_, 0, 1);
  grid->addWidget(slider_, 1, 0, 1, 2);
  grid->addWidget(new QLabel("get there in"), 2, 0);
  grid->addWidget(ramp_, 2, 1);

  at_rest_.setSingleShot(true);
  at_rest_.setInterval(AT_REST_MS);
  connect(slider_, &QSlider::sliderMoved, this, &TemperatureControl::readOutTarget);
  connect(slider_, &QSlider::valueChanged, this, [this](int celsius) {
    readOutTarget(celsius);
    at_rest_.start();
  });
  connect(&at_rest_, &QTimer::timeout, this,
          [this] { Q_EMIT requested(slider_->value(), ramp_->value()); });
  connect(ramp_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this] { Q_EMIT rampChanged(); });
  readOutTarget(slider_->value());
  showInForce(std::nan(""));
}

void TemperatureControl::showTarget(double celsius) {
  if (slider_->isSliderDown() || at_rest_.isActive()) return;
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(std::lround(celsius)));
  readOutTarget(slider_->value());
}

void TemperatureControl::showInForce(double celsius) {
  in_force_->setText(std::isfinite(celsius) ? QString("in force %1 °C").arg(celsius, 0, 'f', 1)
                                            : QString("in force —"));
}

double TemperatureControl::ramp() const { return ramp_->value(); }

void TemperatureControl::setRamp(double seconds) { ramp_->setValue(seconds); }

void TemperatureControl::readOutTarget(int celsius) {
  target_->setText(QString("set %1 °C").arg(celsius));
}

}  // namespace ice_ice_baby
