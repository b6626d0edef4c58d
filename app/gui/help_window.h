// The short built-in help (F1) and the About box.
#pragma once

#include <QDialog>

class QTextBrowser;

namespace lathelier {

class HelpWindow : public QDialog {
    Q_OBJECT
public:
    explicit HelpWindow(QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QTextBrowser* text_;
};

void showAbout(QWidget* parent);

}  // namespace lathelier
