#include "state_view.h"

#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <cmath>

namespace ice_ice_baby {
namespace {

QString count(std::uint32_t number) {
  return QLocale(QLocale::English).toString(static_cast<qulonglong>(number));
}

/// Strictness in words: 0 is water, 1 is ice, between them both. With heat: how much of each.
QString phase(const State& state) {
  if (state.thermal) {
    const QString ice = QString("%p % ice");
    return state.steam_particles > 0 ? ice + ", " + count(state.steam_particles) + " steam" : ice;
  }
  if (state.strictness <= 0.0) return "water";
  const QString ice = state.strictness >= 1.0 ? QString("ice") : QString("freezing %p %");
  return state.asleep ? ice + ", asleep" : ice;
}

}  // namespace

StateView::StateView(QWidget* parent) : QWidget(parent), ice_(new QProgressBar) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(2);
  scene_ = addRow(form, "scene", "scene_value");
  time_ = addRow(form, "simulated", "time_value");
  real_time_ = addRow(form, "real-time factor", "real_time_value");
  particles_ = addRow(form, "particles", "particles_value");
  springs_ = addRow(form, "springs", "springs_value");
  density_error_ = addRow(form, "density error", "density_error_value");
  speed_ = addRow(form, "fastest particle", "speed_value");
  ice_->setObjectName("ice_bar");
  ice_->setRange(0, 100);
  ice_->setToolTip("Strictness, with heat the share of ice: 0 % liquid, 100 % frozen");
  form->addRow("phase", ice_);
  density_error_->setToolTip("Compression, mean and maximum over the particles");
  forget();
}

QLabel* StateView::addRow(QFormLayout* form, const QString& name, const char* object_name) {
  auto* value = new QLabel;
  value->setObjectName(object_name);
  value->setAlignment(Qt::AlignRight);
  form->addRow(name, value);
  values_.push_back(value);
  return value;
}

void StateView::show(const State& state) {
  scene_->setText(QString::fromStdString(
      state.preset.empty() ? state.scene : state.scene + " (" + state.preset + ")"));
  time_->setText(QString("%1 s").arg(state.time_s, 0, 'f', 2));
  real_time_->setText(state.paused ? QString("paused")
                                   : QString("%1").arg(state.real_time_factor, 0, 'f', 2));
  const QString spilled =
      QString(", %1 spilled").arg(count(static_cast<std::uint32_t>(state.spilled)));
  particles_->setText(count(state.particles) + (state.spilled > 0 ? spilled : QString()));
  springs_->setText(count(state.springs));
  density_error_->setText(QString("%1 % / %2 %")
                              .arg(100.0 * state.density_error_mean, 0, 'f', 2)
                              .arg(100.0 * state.density_error_max, 0, 'f', 1));
  speed_->setText(QString("%1 m/s").arg(state.max_speed_m_s, 0, 'f', 2));
  ice_->setValue(static_cast<int>(std::lround(100.0 * state.strictness)));
  ice_->setFormat(phase(state));
}

void StateView::forget() {
  for (QLabel* value : values_) value->setText("—");
  ice_->setValue(0);
  ice_->setFormat("—");
}

}  // namespace ice_ice_baby
