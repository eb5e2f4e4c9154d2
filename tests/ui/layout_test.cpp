// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/layout_audit.h"
#include "tests/ui/workbench_fixture.h"

using namespace gripscope;
using namespace gripscope::test;

// Every page, in the state that the tour shows and when it is empty, in every theme and size: nothing is cut,
// nothing lies over another thing, everything can be hit and named.

class LayoutTest : public QObject {
    Q_OBJECT

    static void audit(WindowFixture& f, const QString& state)
    {
        const std::pair<ThemeKind, const char*> themes[] = {
            {ThemeKind::Light, "light"}, {ThemeKind::Dark, "dark"}, {ThemeKind::HighContrast, "contrast"}};
        QMap<QString, QStringList> where; // by finding, so that each is told once
        for (const auto& [theme, name] : themes) {
            Theme::instance().apply(theme);
            for (const QSize size : {QSize(1024, 640), QSize(1440, 900), QSize(2048, 1280)}) {
                f.window->resize(size);
                QCoreApplication::processEvents();
                QCoreApplication::processEvents();
                for (const QString& finding : LayoutAudit::of(*f.window))
                    where[finding] << QStringLiteral("%1 %2").arg(QLatin1String(name)).arg(size.width());
            }
        }
        Theme::instance().apply(ThemeKind::Light);
        for (auto finding = where.begin(); finding != where.end(); ++finding)
            qWarning("%s %s (%s)", qPrintable(state), qPrintable(finding.key()),
                     qPrintable(finding->join(QStringLiteral(", "))));
        QVERIFY(where.isEmpty());
    }
    static void pages()
    {
        QTest::addColumn<QString>("id");
        for (const char* id : {"live", "inspect", "enroll", "types", "fit", "calibrate", "history"})
            QTest::newRow(id) << QString::fromLatin1(id);
    }

private slots:
    void aPageAtWork_data() { pages(); }
    void aPageAtWork()
    {
        QFETCH(QString, id);
        WindowFixture f(true, QStringLiteral("virtual:"));
        f.window->showPage(id);
        f.page(id)->prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(f.page(id)->tourReady(), 60000);
        f.window->showPage(id);
        audit(f, QStringLiteral("at work"));
    }

    void anEmptyPage_data() { pages(); }
    void anEmptyPage()
    {
        QFETCH(QString, id);
        WindowFixture f(false, QString());
        f.window->showPage(id);
        audit(f, QStringLiteral("empty"));
    }
};

GRIPSCOPE_TEST(LayoutTest)
#include "layout_test.moc"
