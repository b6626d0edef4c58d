// The picture of the 3-D view. VTK draws it aside, and this widget shows it like any other picture: composing a whole
// window through OpenGL, as QOpenGLWidget does, costs a software renderer several times what drawing the scene does.
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
    /// Where canDraw() is true.
    explicit SceneCanvas(QWidget* parent = nullptr);
    ~SceneCanvas() override;

    /// False where there is no OpenGL (an offscreen platform, a missing driver).
    static bool canDraw();

    vtkRenderer& renderer() const;
    void makeCurrent();  ///< before objects of the scene go

    /// Draws once the events that are waiting have been answered, however often it is called before; when hidden, once
    /// it is shown.
    void drawSoon();
    /// Draws at once, also when hidden; the picture in pixels of the device.
    const QImage& drawNow();

    /// Linear share of the full resolution to draw with, 0 to 1.
    void setDetail(double share);

signals:
    void drawn(double seconds);  ///< until the last pixel was there

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
    bool current_ = false;  ///< the picture shows what is to be seen
};

}  // namespace lathelier::scene
