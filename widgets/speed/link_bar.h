// Under the operator's screen: the switch of the link to a control, its state, and the last request.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QWidget>
#include <functional>
#include <optional>

#include "widgets/speed/control_link.h"
#include "widgets/speed/control_window.h"

namespace lathelier::speed_panel {

class LinkBar : public QWidget {
    Q_OBJECT

public:
    explicit LinkBar(QWidget* parent = nullptr);

    /// What is asked of the machine; none: it is not known yet, and nothing can be linked.
    void setQuestion(const std::optional<project::PanelState>& question);

    /// Takes limits, registers and addresses of ASSIST.json; the question stays that of the panel.
    void takeConfiguration(const QString& path);

    ControlLink& controlLink() { return link_; }
    ControlWindow* controlWindow() const { return control_; }
    void retranslate();

signals:
    /// The control asked with these values, and they were answered.
    void asked(const link::ControlValues& values);
    void refused(const Error& error);

private:
    void switchTo(bool on);
    void openControl();
    void askForConfiguration();
    void showState();
    QString stateText() const;

    ControlLink link_;
    link::LinkConfig config_;
    std::optional<project::PanelState> question_;
    QPointer<ControlWindow> control_;
    QPushButton* switch_;
    QComboBox* kinds_;
    QPushButton* configuration_;
    QPushButton* simulator_;
    QLabel* line_;
};

}  // namespace lathelier::speed_panel
