// A chart on the screen, and the mouse over it.
#pragma once

#include <QApplication>
#include <QLocale>
#include <QMouseEvent>
#include <QTest>
#include <memory>

#include "widgets/plot/chart_view.h"

namespace lathelier {

/// A curve over a length with a vertical line to drag.
inline report::Plot parabola()
{
    report::Plot data;
    data.title = "Parabola";
    data.x = {"z", Text{"mm"}};
    data.y = {"radius", Text{"mm"}};
    report::Curve curve;
    curve.name = "copy";
    for (int i = 0; i <= 100; ++i) {
        curve.x.push_back(i);
        curve.y.push_back(0.01 * i * i);
    }
    data.curves.push_back(curve);
    data.handles.push_back({"limit", report::Handle::Kind::Vertical, 80, 0, "+T"});
    return data;
}

inline QWidget* surface(plot::ChartView& view)
{
    return view.findChild<QWidget*>();
}

inline QPoint at(const plot::ChartView& view, double x, double y)
{
    return view.pixelAt(x, y).toPoint();
}

/// Sent straight to the widget: QTest::mouseMove is silent when the pointer is there already.
inline void hover(QWidget* widget, QPoint place)
{
    QMouseEvent move(QEvent::MouseMove, place, Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(widget, &move);
}

inline void drag(QWidget* widget, QPoint from, QPoint to)
{
    QTest::mousePress(widget, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i) {
        QMouseEvent move(QEvent::MouseMove, from + (to - from) * i / 5, Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(widget, &move);
    }
    QTest::mouseRelease(widget, Qt::LeftButton, {}, to);
}

/// A view of the parabola, as large as in a panel.
inline std::unique_ptr<plot::ChartView> shownParabola()
{
    QLocale::setDefault(QLocale::c());
    auto view = std::make_unique<plot::ChartView>();
    view->setData(parabola());
    view->resize(600, 400);
    view->show();
    if (!QTest::qWaitForWindowExposed(view.get())) QTest::qFail("not shown", __FILE__, __LINE__);
    QCoreApplication::processEvents();
    return view;
}

}  // namespace lathelier
