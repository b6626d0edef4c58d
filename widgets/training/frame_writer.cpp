#include "widgets/training/frame_writer.h"

#include <QPixmap>
#include <utility>

namespace lathelier::training_panel {

FrameWriter::FrameWriter(QObject* parent) : QObject(parent)
{
    beat_.setInterval(0);
    connect(&beat_, &QTimer::timeout, this, &FrameWriter::next);
}

void FrameWriter::begin(QWidget& view, const QString& folder, int count, std::function<void(int)> prepare)
{
    if (isWriting()) return;
    folder_ = QDir(folder);
    if (!folder_.mkpath(".")) {
        emit notWritten(folder);
        return;
    }
    view_ = &view;
    count_ = count;
    done_ = 0;
    prepare_ = std::move(prepare);
    beat_.start();
}

void FrameWriter::cancel()
{
    beat_.stop();
}

void FrameWriter::next()
{
    prepare_(done_);
    const QString path = folder_.filePath(QString("frame_%1.png").arg(done_ + 1, 4, 10, QChar('0')));
    if (!view_->grab().save(path)) {
        beat_.stop();
        emit notWritten(path);
        return;
    }
    ++done_;
    emit written(done_, count_);
    if (done_ < count_) return;
    beat_.stop();
    emit finished();
}

}  // namespace lathelier::training_panel
