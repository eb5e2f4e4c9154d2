// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "tests/ui/science_pages.h"
#include "ui/models/cluster_table_model.h"
#include "ui/pages/types_page.h"
#include "ui/scene/scene_view.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>

using namespace gripscope;

namespace {

bool shows(const QWidget& page, const QString& text)
{
    for (const QLabel* label : page.findChildren<QLabel*>())
        if (label->isVisibleTo(&page) && label->text().contains(text))
            return true;
    return false;
}

} // namespace

class TypesPageTest : public QObject {
    Q_OBJECT

    static void open(TypesPage& page)
    {
        page.resize(1000, 700);
        page.show();
        page.setActive(true);
    }

private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void anEmptyLibraryOffersTheExamples()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        open(page);
        QTRY_VERIFY_WITH_TIMEOUT(shows(page, QStringLiteral("No types in this library yet")),
                                 test::patience_ms);
        for (QPushButton* button : page.findChildren<QPushButton*>())
            if (button->text() == QStringLiteral("Load the example types"))
                button->click();
        QTRY_COMPARE_WITH_TIMEOUT(page.view()->content().points.size(), std::size_t(40), test::patience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::patience_ms);
        QCOMPARE(page.view()->content().ellipsoids.size(), std::size_t(4));
        QVERIFY(!shows(page, QStringLiteral("No types in this library yet")));
    }
    void typesCanBeHidden()
    {
        test::PageFixture fixture;
        QVERIFY(fixture.loadExamples());
        TypesPage page(fixture.bench);
        open(page);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::patience_ms);
        const auto checks = page.findChildren<QCheckBox*>();
        QCOMPARE(checks.size(), 4);
        checks[1]->click();
        QCOMPARE(page.view()->content().points.size(), std::size_t(30));
        QCOMPARE(page.view()->content().ellipsoids.size(), std::size_t(3));
    }
    void thePaperShowsTableOneAndItsUnits()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        open(page);
        page.showPaper(true);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady() && page.view()->content().points.size() == 40,
                                 test::patience_ms);
        QCOMPARE(page.findChild<ClusterTableModel*>()->rowCount(), 10);
        QVERIFY(shows(page, QStringLiteral("1.000")));   // adjusted Rand index
        QVERIFY(shows(page, QStringLiteral("3.14529"))); // inertia of the z-scores
        QCOMPARE(page.view()->content().axes[2].title(), QStringLiteral("Stiffness k (as printed)"));
    }
    void stepsWalkTheIterations()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        open(page);
        page.showPaper(true);
        QTRY_VERIFY_WITH_TIMEOUT(page.stepCount() >= 2, test::patience_ms);
        page.showStep(0);
        QCOMPARE(page.view()->content().centroids.size(), std::size_t(4));
        QCOMPARE(page.view()->content().centroids[0].trail.size(), std::size_t(1));
        const QImage first = page.view()->picture();
        page.showStep(page.stepCount() - 1);
        QCOMPARE(int(page.view()->content().centroids[0].trail.size()), page.stepCount());
        QVERIFY(page.view()->picture() != first);
    }
    void aPickedPointTellsItsNumbers()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        open(page);
        page.showPaper(true);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady() && page.view()->content().points.size() == 40,
                                 test::patience_ms);
        QTest::keyClick(page.view(), Qt::Key_N);
        QVERIFY(shows(page, QStringLiteral("A, squeeze 1\nm 0.0368")));
    }
    void aNewInspectionIsRinged()
    {
        test::PageFixture fixture;
        QVERIFY(fixture.loadExamples());
        TypesPage page(fixture.bench);
        open(page);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::patience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(fixture.bench.inspection().state(), InspectSession::State::Ready,
                                  test::patience_ms);
        QVERIFY(fixture.bench.inspection().judgeRecording(simulatedSqueeze(test::canA, 6),
                                                          QStringLiteral("test")));
        QTRY_VERIFY_WITH_TIMEOUT(page.view()->content().highlight.has_value(), test::patience_ms);
        const SceneHighlight& highlight = *page.view()->content().highlight;
        QVERIFY(std::abs(highlight.point.at.z() / test::canA.k - 1) < 0.01);
        QVERIFY(highlight.ellipsoid);
    }
};

GRIPSCOPE_TEST(TypesPageTest)
#include "types_page_test.moc"
