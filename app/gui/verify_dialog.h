// "Verify installation": reference data with known answers are refitted on this computer, and the deviations shown.
#pragma once

#include <QDialog>
#include <memory>

#include "engine/verify/verify.h"
#include "widgets/core/task/task.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace lathelier {

class CopyTable;

/// Begins at once; what it found can be written as a report.
class VerifyDialog : public QDialog {
    Q_OBJECT

public:
    explicit VerifyDialog(QWidget* parent = nullptr);

    /// Null while it computes, or when it was stopped.
    std::shared_ptr<const verify::VerifyResult> result() const { return result_; }

protected:
    void changeEvent(QEvent* event) override;
    void done(int answer) override;

private:
    void retranslate();
    void showResult();
    void writeReportFile();

    std::shared_ptr<const verify::VerifyResult> result_;
    QLabel* headline_;
    QLabel* about_;
    CopyTable* table_;
    QProgressBar* bar_;
    QPushButton* report_;
    QPushButton* close_;
    Task task_;
};

}  // namespace lathelier
