// Writes a demonstration as numbered images, one per event loop iteration, so that the window stays responsive.
#pragma once

#include <QDir>
#include <QObject>
#include <QTimer>
#include <QWidget>
#include <functional>

namespace lathelier::training_panel {

class FrameWriter : public QObject {
    Q_OBJECT

public:
    explicit FrameWriter(QObject* parent = nullptr);

    /// `count` pictures of `view`, frame_0001.png and on, in `folder`; `prepare` puts the view to frame i of `count`.
    void begin(QWidget& view, const QString& folder, int count, std::function<void(int)> prepare);
    bool isWriting() const { return beat_.isActive(); }
    void cancel();  ///< stops; frames written are kept

signals:
    void written(int frames, int count);
    void finished();
    void notWritten(const QString& path);

private:
    void next();

    QWidget* view_ = nullptr;
    QDir folder_;
    int count_ = 0;
    int done_ = 0;
    std::function<void(int)> prepare_;
    QTimer beat_;
};

}  // namespace lathelier::training_panel
