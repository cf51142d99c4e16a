// The live numbers of a simulation.
#pragma once

#include <ice_ice_baby/State.h>

#include <QWidget>
#include <vector>

class QFormLayout;
class QLabel;
class QProgressBar;

namespace ice_ice_baby {

/// Two columns, name and value; grey dashes while nothing is known.
class StateView : public QWidget {
  Q_OBJECT

 public:
  explicit StateView(QWidget* parent = nullptr);

  void show(const State& state);
  void forget();

 private:
  QLabel* addRow(QFormLayout* form, const QString& name, const char* object_name);

  QLabel* scene_;
  QLabel* time_;
  QLabel* real_time_;
  QLabel* particles_;
  QLabel* springs_;
  QLabel* density_error_;
  QLabel* speed_;
  QProgressBar* ice_;
  std::vector<QLabel*> values_;
};

}  // namespace ice_ice_baby
