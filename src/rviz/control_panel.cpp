#include "control_panel.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>
#include <string>
#include <vector>

#include "state_view.h"
#include "temperature_control.h"

Q_DECLARE_METATYPE(ice_ice_baby::Answer)
Q_DECLARE_METATYPE(ice_ice_baby::State)

namespace ice_ice_baby {
namespace {

const char* const kDefaultNode = "/ice_ice_baby";
constexpr double kArrived_c = 0.05;  ///< so close to the target it counts as reached
constexpr int kWatch_ms = 1000;
constexpr int kSilence_ms = 2000;  ///< without a state for so long the node is asked

QPushButton* makeButton(const char* text, const char* object_name, const char* tip) {
  auto* button = new QPushButton(text);
  button->setObjectName(object_name);
  button->setToolTip(tip);
  return button;
}

QStringList words(const std::vector<std::string>& names) {
  QStringList list;
  for (const std::string& name : names) list << QString::fromStdString(name);
  return list;
}

}  // namespace

ControlPanel::ControlPanel(QWidget* parent)
    : rviz::Panel(parent),
      node_(new QLineEdit(kDefaultNode)),
      temperature_(new TemperatureControl),
      pause_(makeButton("Pause", "pause_button", "Holds the simulation or lets it run on")),
      step_(makeButton("Step", "step_button", "One frame, while paused")),
      reset_(makeButton("Reset", "reset_button", "The scene from the start")),
      scene_(new QComboBox),
      preset_(new QComboBox),
      state_view_(new StateView),
      answer_(new QLabel) {
  qRegisterMetaType<Answer>("ice_ice_baby::Answer");
  qRegisterMetaType<State>("ice_ice_baby::State");
  layOut();
  connectInputs();
  connectClient();
  followNode(node_->text());
  watch_.start(kWatch_ms);
}

ControlPanel::~ControlPanel() = default;

void ControlPanel::layOut() {
  node_->setObjectName("node");
  node_->setToolTip("Name of the simulation's node");
  scene_->setObjectName("scene");
  scene_->setToolTip("Starts the chosen scene");
  preset_->setObjectName("preset");
  preset_->setToolTip("Solver settings; a choice starts the scene anew with them");
  preset_->addItem("scene's preset", QString());
  preset_->addItem("default", "default");
  preset_->addItem("paper", "paper");
  answer_->setObjectName("answer");
  answer_->setWordWrap(true);
  answer_->setTextFormat(Qt::PlainText);

  auto* names = new QFormLayout;
  names->addRow("node", node_);
  names->addRow("scene", scene_);
  names->addRow("preset", preset_);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(pause_);
  buttons->addWidget(step_);
  buttons->addWidget(reset_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(names);
  column->addLayout(buttons);
  column->addWidget(temperature_);
  column->addWidget(state_view_);
  column->addWidget(answer_);
  column->addStretch(1);
}

void ControlPanel::connectInputs() {
  connect(node_, &QLineEdit::editingFinished, this, [this] {
    if (node_->text().toStdString() == client_->node()) return;
    followNode(node_->text());
    Q_EMIT configChanged();
  });
  connect(temperature_, &TemperatureControl::requested, this,
          [this](double celsius, double ramp_s, const QString& collider) {
            if (collider.isEmpty()) target_ = celsius;
            client_->setTemperature(celsius, ramp_s, collider.toStdString());
          });
  connect(temperature_, &TemperatureControl::rampChanged, this, &ControlPanel::configChanged);
  connect(pause_, &QPushButton::clicked, this,
          [this] { paused_ ? client_->resume() : client_->pause(); });
  connect(step_, &QPushButton::clicked, this, [this] { client_->step(1); });
  connect(reset_, &QPushButton::clicked, this, [this] { startScene(QString()); });
  connect(preset_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { startScene(QString()); });
  connect(scene_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { startScene(scene_->currentText()); });
  connect(&watch_, &QTimer::timeout, this, &ControlPanel::checkNode);
}

void ControlPanel::connectClient() {
  connect(this, &ControlPanel::answerArrived, this, &ControlPanel::showAnswer,
          Qt::QueuedConnection);
  connect(this, &ControlPanel::stateArrived, this, &ControlPanel::showState, Qt::QueuedConnection);
  connect(this, &ControlPanel::scenesArrived, this, &ControlPanel::showScenes,
          Qt::QueuedConnection);
  SimulationClient::Callbacks callbacks;
  callbacks.answered = [this](const Answer& answer) { Q_EMIT answerArrived(answer); };
  callbacks.state = [this](const State& state) { Q_EMIT stateArrived(state); };
  callbacks.scenes = [this](const std::vector<std::string>& names) {
    Q_EMIT scenesArrived(words(names));
  };
  client_ = std::make_unique<SimulationClient>(std::move(callbacks));
}

void ControlPanel::followNode(const QString& node) {
  since_state_.invalidate();
  reached_ = false;
  asked_ = false;
  target_.reset();
  state_view_->forget();
  temperature_->showInForce(std::nan(""), std::nan(""));
  if (!client_->follow(node.toStdString())) {
    showLine(QString("\"%1\" is no ROS name").arg(node), false);
    return;
  }
  node_->setText(QString::fromStdString(client_->node()));
}

void ControlPanel::startScene(const QString& scene) {
  client_->reset(scene.toStdString(), preset_->currentData().toString().toStdString());
}

void ControlPanel::showAnswer(const Answer& answer) {
  const bool asked_by_watch = answer.service == "get_state";
  if (!answer.reached) {
    state_view_->forget();
    temperature_->showInForce(std::nan(""), std::nan(""));
    target_.reset();
  }
  const bool regained = answer.reached && !reached_;
  reached_ = answer.reached;
  if (asked_by_watch) asked_ = false;
  if (asked_by_watch && answer.success) {
    if (regained) showLine("connected", true);
    return;
  }
  const bool overtaken = answer.service == "reset" && answer.success;
  const bool refused = answer.service == "set_temperature" && !answer.success;
  if (overtaken || refused) target_.reset();
  const QString words = QString::fromStdString(answer.message);
  showLine(answer.reached ? QString::fromStdString(answer.service) + ": " + words : words,
           answer.success);
}

void ControlPanel::showState(const State& state) {
  since_state_.start();
  paused_ = state.paused;
  pause_->setText(paused_ ? "Resume" : "Pause");
  step_->setEnabled(paused_);
  state_view_->show(state);
  temperature_->showInForce(state.temperature,
                            state.thermal ? state.mean_temperature : std::nan(""));
  temperature_->offerTargets(state.thermal, words(state.targets));
  if (target_ && std::abs(state.temperature - *target_) < kArrived_c) target_.reset();
  if (!target_) temperature_->showTarget(state.temperature);
  if (scene_->view()->isVisible()) return;
  scene_->setCurrentText(QString::fromStdString(state.scene));
}

void ControlPanel::showScenes(const QStringList& scenes) {
  const QSignalBlocker quiet(scene_);
  const QString chosen = scene_->currentText();
  scene_->clear();
  scene_->addItems(scenes);
  scene_->setCurrentText(chosen);
}

void ControlPanel::showLine(const QString& text, bool good) {
  answer_->setText(text);
  answer_->setStyleSheet(good ? "color: #2e7d4f" : "color: #b3362b");
}

/// Calls a node that has been silent, because it may be paused, new or gone, and one that has not
/// answered yet, because states may arrive before its services can be called.
void ControlPanel::checkNode() {
  const bool silent = !since_state_.isValid() || since_state_.elapsed() > kSilence_ms;
  if (asked_ || (reached_ && !silent)) return;
  asked_ = true;
  client_->refresh();
}

void ControlPanel::load(const rviz::Config& config) {
  rviz::Panel::load(config);
  QString node;
  if (config.mapGetString("Node", &node)) followNode(node);
  float ramp_s = 0.0F;
  if (config.mapGetFloat("Ramp", &ramp_s)) temperature_->setRamp(ramp_s);
}

void ControlPanel::save(rviz::Config config) const {
  rviz::Panel::save(config);
  config.mapSetValue("Node", QString::fromStdString(client_->node()));
  config.mapSetValue("Ramp", temperature_->ramp());
}

}  // namespace ice_ice_baby

PLUGINLIB_EXPORT_CLASS(ice_ice_baby::ControlPanel, rviz::Panel)
