// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QTest>
#include <QVBoxLayout>
#include <QWidget>

#include <memory>

using namespace gripscope;

namespace {

/// Counts how often it was styled.
class Styled : public QWidget {
public:
    using QWidget::QWidget;
    int times = 0;

protected:
    void changeEvent(QEvent* event) override
    {
        if (event->type() == QEvent::StyleChange)
            ++times;
        QWidget::changeEvent(event);
    }
};

/// Made as a page is: each part gets its place in another when it is complete. Returns the innermost.
Styled* nestedIn(QWidget& window, int depth)
{
    auto* innermost = new Styled;
    QWidget* part = innermost;
    for (int i = 0; i < depth; ++i) {
        auto* outer = new QWidget;
        auto* layout = new QVBoxLayout(outer);
        layout->addWidget(part);
        part = outer;
    }
    auto* layout = new QVBoxLayout(&window);
    layout->addWidget(part);
    return innermost;
}

} // namespace

/// Every widget of the window is styled when it is made and when the theme changes. That must not grow with
/// the number of widgets that it stands in: the window has a thousand, ten deep.
class StylingOnceTest : public QObject {
    Q_OBJECT
private slots:
    void init() { Theme::instance().apply(ThemeKind::Light); }
    void cleanup() { Theme::instance().apply(ThemeKind::Light); }

    void anotherTheme()
    {
        QWidget window;
        Styled* innermost = nestedIn(window, 10);
        window.show();
        innermost->times = 0;
        Theme::instance().apply(ThemeKind::Dark);
        QVERIFY(innermost->times > 0);
        QVERIFY2(innermost->times <= 2, qPrintable(QString::number(innermost->times))); // sheet off, sheet on
    }
    void aWindowThatIsMade()
    {
        QWidget window;
        Styled* innermost = nullptr;
        {
            const Theme::PlainStyle plain;
            innermost = nestedIn(window, 10);
        }
        QVERIFY2(innermost->times <= 1, qPrintable(QString::number(innermost->times)));
        QVERIFY(!qApp->styleSheet().isEmpty());
    }
    /// What is seen keeps its looks while another window is made.
    void oneThatIsThere()
    {
        QWidget window;
        window.show();
        const Theme::PlainStyle plain;
        QVERIFY(!qApp->styleSheet().isEmpty());
    }
};

GRIPSCOPE_TEST(StylingOnceTest)
#include "styling_once_test.moc"
