// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/inspect_session.h"
#include "tests/support/test_registry.h"
#include "tests/ui/inspecting.h"
#include "ui/windows/question.h"

#include <QFile>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::longEnough_ms;
using gripscope::test::WindowFixture;
using namespace gripscope::test::inspecting;

/// The window's end.
class ClosingTest : public QObject {
    Q_OBJECT
private slots:
    /// The next program stores it: nothing would be lost, and nobody is asked.
    void whatWaitsInTheSpillFileIsNotAskedAbout();
};

void ClosingTest::whatWaitsInTheSpillFileIsNotAskedAbout()
{
    Armed armed;
    WindowFixture& f = armed.f;
    const QString library = f.bench->library().file();
    const QString away = library + u".away"_s;
    QVERIFY(QFile::rename(library, away));
    f.click(f.find<QPushButton>("squeezeButton"));
    const InspectSession& inspection = f.bench->inspection();
    QTRY_VERIFY_WITH_TIMEOUT(inspection.unstored() == 1 && !inspection.storing() && inspection.spilled() == 1,
                             longEnough_ms);
    f.window->close();
    QVERIFY(!f.window->findChild<Question*>());
    QVERIFY(!f.window->isVisible());
    QVERIFY(QFile::rename(away, library));
}

GRIPSCOPE_TEST(ClosingTest)
#include "closing_test.moc"
