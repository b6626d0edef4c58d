// The picture of the 3-D view. VTK renders off screen and this widget shows the image: composing a whole window through
// OpenGL, as QOpenGLWidget does, costs a software renderer several times what drawing the scene does.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <memory>

class vtkRenderer;

namespace lathelier::scene {

class SceneCanvas : public QWidget {
    Q_OBJECT

public:
    /// Precondition: canDraw().
    explicit SceneCanvas(QWidget* parent = nullptr);
    ~SceneCanvas() override;

    /// False where there is no OpenGL (an offscreen platform, a missing driver).
    static bool canDraw();

    vtkRenderer& renderer() const;
    void makeCurrent();  ///< required before objects of the scene are destroyed

    /// Schedules one redraw after pending events; when hidden, as soon as it is shown.
    void drawSoon();
    /// Draws at once, also when hidden; the picture in pixels of the device.
    const QImage& drawNow();

    /// Linear share of the full resolution to draw with, 0 to 1.
    void setDetail(double share);

signals:
    void drawn(double seconds);  ///< seconds until completion

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    struct Graphics;
    void readPicture(int width, int height);

    std::unique_ptr<Graphics> graphics_;
    QImage picture_;
    QTimer soon_;
    double detail_ = 1;
    bool current_ = false;  ///< the image is up to date
};

}  // namespace lathelier::scene
