// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/session/fake_gripper.h"
#include "tests/support/test_registry.h"
#include "ui/theme/theme.h"
#include "ui/windows/stop_controls.h"

#include <QTest>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

namespace {

/// A window with a row at its top, on a gripper that does what the test says.
struct NoticeWindow {
    explicit NoticeWindow(const QSize& size)
    {
        auto* column = new QVBoxLayout(&window);
        column->setContentsMargins(0, 0, 0, 0);
        bar->setFixedHeight(64);
        column->addWidget(bar);
        column->addStretch(1);
        notice = new StopNotice(session, bar, &window);
        window.resize(size);
        window.show();
        if (!QTest::qWaitForWindowExposed(&window) || !session.connectTo(u"fake:"_s))
            qFatal("there is no window");
        poll();
        (void)session.arm(u"Ada"_s);
        poll();
    }
    void poll()
    {
        session.poll();
        notice->refresh();
    }
    void disobey()
    {
        factory.gripper->obeysStop = false;
        session.stop();
        poll();
    }

    FakeGripperFactory factory;
    ConnectSession session{factory};
    QWidget window;
    QWidget* bar = new QWidget(&window);
    StopNotice* notice = nullptr;
};

} // namespace

/// What is said of a gripper that did not obey Stop.
class StopNoticeTest : public QObject {
    Q_OBJECT
private slots:
    void itIsLargeAndBesideTheStop_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("leastPixels");
        QTest::newRow("the least window") << QSize(1024, 640) << 72; // read from 3 m
        QTest::newRow("a large one") << QSize(1920, 1080) << 72;
        QTest::newRow("a large dialog") << QSize(880, 600) << 64;
        QTest::newRow("a small dialog") << QSize(480, 260) << 28;
    }
    void itIsLargeAndBesideTheStop()
    {
        QFETCH(QSize, size);
        QFETCH(int, leastPixels);
        NoticeWindow w(size);
        QVERIFY(!w.notice->isVisible());
        w.disobey();
        QVERIFY(w.notice->isVisible());
        QCOMPARE(w.notice->accessibleName(), u"The gripper did not obey Stop. Switch off its power."_s);
        QVERIFY2(w.notice->fontPixels() >= leastPixels, qPrintable(QString::number(w.notice->fontPixels())));
        QVERIFY(!w.notice->geometry().intersects(w.bar->geometry()));
        QVERIFY(w.window.rect().contains(w.notice->geometry()));
        w.window.resize(size + QSize(100, 0)); // and stays along the whole window
        QTRY_COMPARE(w.notice->width(), size.width() + 100);
    }

    void itHasTheMostContrastOfTheTheme_data()
    {
        QTest::addColumn<int>("kind");
        QTest::newRow("light") << int(ThemeKind::Light);
        QTest::newRow("dark") << int(ThemeKind::Dark);
        QTest::newRow("high contrast") << int(ThemeKind::HighContrast);
    }
    void itHasTheMostContrastOfTheTheme()
    {
        QFETCH(int, kind);
        Theme::instance().apply(static_cast<ThemeKind>(kind));
        NoticeWindow w({1024, 640});
        w.disobey();
        const QImage shown = w.notice->grab().toImage();
        int words = 0, ground = 0;
        const ThemeTokens& t = Theme::instance().tokens();
        for (int y = 0; y < shown.height(); ++y)
            for (int x = 0; x < shown.width(); ++x) {
                words += shown.pixelColor(x, y) == t.page ? 1 : 0;
                ground += shown.pixelColor(x, y) == t.text ? 1 : 0;
            }
        const int all = shown.width() * shown.height();
        QVERIFY2(words > all / 20 && ground > all / 2,
                 qPrintable(u"%1, %2 of %3"_s.arg(words).arg(ground).arg(all)));
        QVERIFY(Theme::contrastRatio(t.page, t.text) >= 14);
        Theme::instance().apply(ThemeKind::Light);
    }

    void itStaysUntilTheGripperWasConnectedAnew()
    {
        NoticeWindow w({1024, 640});
        w.disobey();
        QTest::mouseClick(w.notice, Qt::LeftButton);
        QTest::keyClick(&w.window, Qt::Key_Escape);
        w.session.stop();
        w.poll();
        QVERIFY(w.notice->isVisible());
        w.factory.gripper->state = LinkState::Lost; // its power was switched off
        w.factory.gripper->error = Error{ErrorCode::DeviceLost, {u"fake:"_s, u"unplugged"_s}};
        w.poll();
        QVERIFY(w.notice->isVisible());
        w.factory.comeback->there = std::make_shared<FakeGripper>();
        w.poll();
        w.poll();
        QCOMPARE(w.session.state(), ConnectSession::State::Connected);
        QVERIFY(!w.notice->isVisible());
    }
};

GRIPSCOPE_TEST(StopNoticeTest)
#include "stop_notice_test.moc"
