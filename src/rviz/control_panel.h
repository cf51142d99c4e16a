// The control panel in rviz: temperature, pause, scenes and the simulation's live numbers.
#pragma once

#include <rviz/panel.h>

#include <QElapsedTimer>
#include <QStringList>
#include <QTimer>
#include <memory>
#include <optional>

#include "simulation_client.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace ice_ice_baby {

class StateView;
class TemperatureControl;

/// Controls one simulation node. Saved with the rviz config: the node's name and the ramp.
class ControlPanel : public rviz::Panel {
  Q_OBJECT

 public:
  explicit ControlPanel(QWidget* parent = nullptr);
  ~ControlPanel() override;

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 Q_SIGNALS:
  // Emitted on the client's threads and received on the GUI thread.
  void answerArrived(const ice_ice_baby::Answer& answer);
  void stateArrived(const ice_ice_baby::State& state);
  void scenesArrived(const QStringList& scenes);

 private:
  void layOut();
  void connectInputs();
  void connectClient();
  void followNode(const QString& node);
  void startScene(const QString& scene);

  void showAnswer(const Answer& answer);
  void showState(const State& state);
  void showScenes(const QStringList& scenes);
  void showLine(const QString& text, bool good);
  void checkNode();

  QLineEdit* node_;
  TemperatureControl* temperature_;
  QPushButton* pause_;
  QPushButton* step_;
  QPushButton* reset_;
  QComboBox* scene_;
  QComboBox* preset_;
  StateView* state_view_;
  QLabel* answer_;

  QTimer watch_;
  QElapsedTimer since_state_;
  bool paused_ = false;
  bool reached_ = false;          ///< whether the node answered the latest call
  bool asked_ = false;            ///< whether an answer is still pending
  std::optional<double> target_;  ///< requested and not yet in force; empty: the slider follows

  std::unique_ptr<SimulationClient> client_;  ///< last, so that its threads end before the widgets
};

}  // namespace ice_ice_baby
