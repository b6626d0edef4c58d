// The title block of the project's reports, asked for in a dialog.
#pragma once

#include <QDialog>
#include <QLabel>
#include <QPushButton>

#include "engine/project/project.h"
#include "engine/report/title_block.h"

namespace lathelier {

class Form;

/// The picture in the file at `path`, no larger than a report needs, as PNG in base64. Error malformed
/// when it is no picture or cannot be read.
std::string readLogo(const QString& path);

/// The title block of a project; where the project has none, what does not change from part to part (company,
/// instrument, inspector) as it was given last.
report::TitleBlock titleBlockOf(const project::Project& project);

class TitleBlockDialog : public QDialog {
    Q_OBJECT
public:
    explicit TitleBlockDialog(const report::TitleBlock& block, QWidget* parent = nullptr);

    /// As filled in.
    report::TitleBlock block() const;

    /// Keeps what does not change from part to part for the next project.
    static void keep(const report::TitleBlock& block);

private:
    void showLogo();

    Form* form_;
    QLabel* logo_;
    QPushButton* remove_;
    QLabel* problem_;
    std::string logoPngBase64_;
};

}  // namespace lathelier
