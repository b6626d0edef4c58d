#include "widgets/scene/scene_canvas.h"

#include <QVTKRenderWindowAdapter.h>
#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QPaintEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"

namespace lathelier::scene {

struct SceneCanvas::Graphics {
    QOffscreenSurface surface;
    QOpenGLContext context;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkCallbackCommand> observer;
    vtkNew<vtkUnsignedCharArray> pixels;

    Graphics()
    {
        QSurfaceFormat format = QVTKRenderWindowAdapter::defaultFormat();
        format.setSamples(0);  // no multisampling, which is slow in software rendering
        context.setFormat(format);
        context.create();
        surface.setFormat(context.format());
        surface.create();
        observer->SetClientData(this);
        observer->SetCallback([](vtkObject*, unsigned long event, void* self, void* answer) {
            auto& graphics = *static_cast<Graphics*>(self);
            if (event == vtkCommand::WindowMakeCurrentEvent)
                graphics.makeCurrent();
            else
                *static_cast<bool*>(answer) = QOpenGLContext::currentContext() == &graphics.context;
        });
        window->AddObserver(vtkCommand::WindowMakeCurrentEvent, observer);
        window->AddObserver(vtkCommand::WindowIsCurrentEvent, observer);
        makeCurrent();
        window->SetOwnContext(0);
        window->SetMultiSamples(0);
        window->SetFrameBlitModeToNoBlit();
        window->SetReadyForRendering(true);
        window->OpenGLInitContext();
        window->AddRenderer(renderer);
    }
    ~Graphics()
    {
        makeCurrent();
        window->Finalize();
        window->RemoveAllObservers();
        context.doneCurrent();
    }
    void makeCurrent() { context.makeCurrent(&surface); }
};

SceneCanvas::SceneCanvas(QWidget* parent) : QWidget(parent), graphics_(std::make_unique<Graphics>())
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, [this] {
        if (!isVisible()) return;
        drawNow();
        update();
    });
}

SceneCanvas::~SceneCanvas() = default;

bool SceneCanvas::canDraw()
{
    const QString platform = QGuiApplication::platformName();
    if (platform == "offscreen" || platform == "minimal") return false;
    QOpenGLContext context;
    context.setFormat(QVTKRenderWindowAdapter::defaultFormat());
    return context.create();
}

vtkRenderer& SceneCanvas::renderer() const
{
    return *graphics_->renderer;
}

void SceneCanvas::makeCurrent()
{
    graphics_->makeCurrent();
}

void SceneCanvas::setDetail(double share)
{
    detail_ = share;
}

void SceneCanvas::drawSoon()
{
    current_ = false;
    if (isVisible()) soon_.start();
}

const QImage& SceneCanvas::drawNow()
{
    const double scale = detail_ * devicePixelRatioF();
    const int wide = std::max(1, static_cast<int>(std::lround(width() * scale)));
    const int high = std::max(1, static_cast<int>(std::lround(height() * scale)));
    QElapsedTimer clock;
    clock.start();
    graphics_->window->SetSize(wide, high);
    graphics_->renderer->ResetCameraClippingRange();
    graphics_->window->Render();
    readPicture(wide, high);
    soon_.stop();
    current_ = true;
    emit drawn(static_cast<double>(clock.nsecsElapsed()) * 1e-9);
    return picture_;
}

void SceneCanvas::readPicture(int width, int height)
{
    vtkUnsignedCharArray* pixels = graphics_->pixels;
    graphics_->window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels);
    if (picture_.size() != QSize(width, height)) picture_ = QImage(width, height, QImage::Format_RGB32);
    const unsigned char* from = pixels->GetPointer(0);
    auto* to = reinterpret_cast<QRgb*>(picture_.bits());
    const auto row = static_cast<std::size_t>(width);
    // OpenGL begins with the lowest row.
    parallelFor(static_cast<std::size_t>(height), 64, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
            const unsigned char* in = from + 4 * row * (static_cast<std::size_t>(height) - 1 - y);
            QRgb* out = to + row * y;
            for (std::size_t x = 0; x < row; ++x, in += 4)
                out[x] = 0xff000000U | unsigned{in[0]} << 16 | unsigned{in[1]} << 8 | in[2];
        }
    });
}

void SceneCanvas::paintEvent(QPaintEvent* event)
{
    if (picture_.isNull()) drawNow();
    QPainter painter(this);
    const double scale = static_cast<double>(picture_.width()) / width();
    const QRectF part = event->rect();
    painter.drawImage(part, picture_, QRectF(part.topLeft() * scale, part.size() * scale));
}

void SceneCanvas::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    drawSoon();
}

void SceneCanvas::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!current_) drawSoon();
}

}  // namespace lathelier::scene
