// A simulated control in a window of its own: the other side of the link, for a class that sees both.
#pragma once

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QWidget>
#include <map>
#include <string>

#include "engine/link/loopback/simulated_control.h"

namespace lathelier::speed_panel {

class ControlWindow : public QWidget {
    Q_OBJECT

public:
    /// Begins to listen. Error linkPortNotFree.
    explicit ControlWindow(QWidget* parent = nullptr);

    int port() const { return control_.port(); }
    link::SimulatedControl& control() { return control_; }

signals:
    void closed();

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void ask();
    void retranslate();
    void showState();

    link::SimulatedControl control_;
    std::map<std::string, QDoubleSpinBox*> fields_;
    std::map<std::string, QLabel*> names_;
    QCheckBox* running_;
    QPushButton* ask_;
    QLabel* corrected_;
    QLabel* stateLine_;
    QLabel* linkLine_;
    QTimer* look_;
};

}  // namespace lathelier::speed_panel
