// The small settings dialog.
#pragma once

#include <QDialog>

#include "app/gui/settings.h"

class QComboBox;
class QSpinBox;

namespace lathelier {

class SettingsDialog : public QDialog {
    Q_OBJECT
public:
    explicit SettingsDialog(const Settings& settings, QWidget* parent = nullptr);
    Settings settings() const;

private:
    QComboBox* language_;
    QComboBox* theme_;
    QSpinBox* presenter_;
    QComboBox* decision_;
    QComboBox* length_;
    QComboBox* form_;
};

}  // namespace lathelier
