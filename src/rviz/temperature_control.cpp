#include "temperature_control.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

namespace ice_ice_baby {
namespace {

constexpr int kColdest_c = -30;
constexpr int kWarmest_c = 40;
constexpr int kWarmestThermal_c = 150;
constexpr int kAtRest_ms = 150;

/// Whitish up to the freezing point, at a given fraction of the groove, then from blue to red.
QString sliderStyle(double freezing) {
  return QString(
             "QSlider::groove:horizontal { height: 8px; border-radius: 4px; background: "
             "qlineargradient(x1:0, y1:0, x2:1, y2:0, stop:0 #eef6fb, stop:%1 #7fb6de, "
             "stop:%2 #2f7dc0, stop:1 #d4694a); }"
             "QSlider::handle:horizontal { width: 14px; margin: -5px 0; border-radius: 7px;"
             " background: #ffffff; border: 2px solid #3a4a58; }")
      .arg(freezing - 0.01)
      .arg(freezing + 0.02);
}

}  // namespace

TemperatureControl::TemperatureControl(QWidget* parent)
    : QWidget(parent),
      slider_(new QSlider(Qt::Horizontal)),
      target_(new QLabel),
      in_force_(new QLabel),
      of_(new QLabel("of")),
      choice_(new QComboBox),
      ramp_(new QDoubleSpinBox) {
  slider_->setObjectName("temperature_slider");
  setWarmest(kWarmest_c);
  slider_->setTracking(false);
  slider_->setToolTip("Temperature to reach. Water freezes below 0 °C.");
  in_force_->setObjectName("temperature_in_force");
  in_force_->setAlignment(Qt::AlignRight);
  ramp_->setObjectName("ramp");
  ramp_->setRange(0.0, 600.0);
  ramp_->setDecimals(1);
  ramp_->setSuffix(" s");
  ramp_->setToolTip("Simulated time in which the temperature gets there. 0: at once.");
  choice_->setObjectName("temperature_target");
  choice_->setToolTip("What the temperature is set of: the air or the surface of a collider");
  layOut();

  at_rest_.setSingleShot(true);
  at_rest_.setInterval(kAtRest_ms);
  connect(slider_, &QSlider::sliderMoved, this, &TemperatureControl::readOutTarget);
  connect(slider_, &QSlider::valueChanged, this, [this](int celsius) {
    readOutTarget(celsius);
    at_rest_.start();
  });
  connect(&at_rest_, &QTimer::timeout, this,
          [this] { Q_EMIT requested(slider_->value(), ramp_->value(), collider()); });
  connect(ramp_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this] { Q_EMIT rampChanged(); });
  readOutTarget(slider_->value());
  showInForce(std::nan(""), std::nan(""));
  offerTargets(false, {});
}

void TemperatureControl::layOut() {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(target_, 0, 0);
  grid->addWidget(in_force_, 0, 1);
  grid->addWidget(slider_, 1, 0, 1, 2);
  grid->addWidget(of_, 2, 0);
  grid->addWidget(choice_, 2, 1);
  grid->addWidget(new QLabel("ramp"), 3, 0);
  grid->addWidget(ramp_, 3, 1);
}

void TemperatureControl::offerTargets(bool thermal, const QStringList& colliders) {
  QStringList offered;
  for (int k = 1; k < choice_->count(); ++k) offered << choice_->itemText(k);
  if (choice_->count() == 0 || offered != colliders) {
    const QString chosen = collider();
    choice_->clear();
    choice_->addItem("air", QString());
    for (const QString& name : colliders) choice_->addItem(name, name);
    choice_->setCurrentIndex(std::max(0, choice_->findData(chosen)));
  }
  of_->setVisible(thermal);
  choice_->setVisible(thermal);
  setWarmest(thermal ? kWarmestThermal_c : kWarmest_c);
}

void TemperatureControl::setWarmest(int celsius) {
  if (slider_->maximum() == celsius && slider_->minimum() == kColdest_c) return;
  const QSignalBlocker quiet(slider_);
  slider_->setRange(kColdest_c, celsius);
  slider_->setStyleSheet(sliderStyle(-double(kColdest_c) / (celsius - kColdest_c)));
}

QString TemperatureControl::collider() const { return choice_->currentData().toString(); }

void TemperatureControl::showTarget(double celsius) {
  if (!collider().isEmpty()) return;
  if (slider_->isSliderDown() || at_rest_.isActive()) return;
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(std::lround(celsius)));
  readOutTarget(slider_->value());
}

void TemperatureControl::showInForce(double celsius, double mean_c) {
  const auto text = [](double c) { return QString("%1 °C").arg(c, 0, 'f', 1); };
  if (!std::isfinite(celsius)) {
    in_force_->setText("current —");
  } else if (std::isfinite(mean_c)) {
    in_force_->setText("air " + text(celsius) + ", mean " + text(mean_c));
  } else {
    in_force_->setText("current " + text(celsius));
  }
}

double TemperatureControl::ramp() const { return ramp_->value(); }

void TemperatureControl::setRamp(double seconds) { ramp_->setValue(seconds); }

void TemperatureControl::readOutTarget(int celsius) {
  target_->setText(QString("set %1 °C").arg(celsius));
}

}  // namespace ice_ice_baby
