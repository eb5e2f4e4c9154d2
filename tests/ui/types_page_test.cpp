// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "tests/ui/science_pages.h"
#include "ui/charts/heat_map.h"
#include "ui/models/cluster_models.h"
#include "ui/pages/types/types_page.h"
#include "ui/pages/types/types_page_clusters.h"
#include "ui/scene/scene_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>

using namespace gripscope;

namespace {

bool shows(const QWidget& page, const QString& text)
{
    for (const QLabel* label : page.findChildren<QLabel*>())
        if (label->isVisibleTo(&page) && label->text().contains(text))
            return true;
    return false;
}

/// A button in view by the beginning of its words; null when there is none.
QPushButton* findButton(const QWidget& page, const QString& text)
{
    for (QPushButton* one : page.findChildren<QPushButton*>())
        if (one->isVisibleTo(&page) && one->text().startsWith(text))
            return one;
    return nullptr;
}

QPushButton* button(const QWidget& page, const QString& text)
{
    QPushButton* found = findButton(page, text);
    if (!found)
        qFatal("there is no button %s", qPrintable(text));
    return found;
}

void click(QAbstractButton* what)
{
    QTest::mouseClick(what, Qt::LeftButton);
}

/// Chooses an entry of a box by the keyboard, as a person may.
void choose(QWidget& page, const char* box, int entry)
{
    auto* combo = page.findChild<QComboBox*>(QString::fromLatin1(box));
    QTest::keyClick(combo, Qt::Key_Home);
    for (int i = 0; i < entry; ++i)
        QTest::keyClick(combo, Qt::Key_Down);
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
    static void openPaper(TypesPage& page)
    {
        open(page);
        page.showPaper(true);
        QTRY_VERIFY_WITH_TIMEOUT(page.stepCount() >= 2 && page.view()->content().points.size() == 40,
                                 test::longEnough_ms);
    }

    /// Adds a squeeze to a type, which is made where there is none.
    static void enrol(test::PageFixture& fixture, const QString& type)
    {
        bool done = false;
        fixture.bench.background().ask<GraspRecord>(
            nullptr,
            [type](Library& library) -> Expected<GraspRecord> {
                QString id;
                for (const TypeRecord& one : test::valueOf(library.types()))
                    if (one.name == type)
                        id = one.id;
                if (id.isEmpty())
                    id =
                        test::valueOf(library.addType(type, {}, QStringLiteral("N"), QStringLiteral("m"))).id;
                return library.addGrasp(test::aGrasp(id));
            },
            [&](const Expected<GraspRecord>& added) { done = added.has_value(); });
        QTRY_VERIFY_WITH_TIMEOUT(done, test::longEnough_ms);
        fixture.bench.tellLibraryChanged();
    }

private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void anEmptyLibraryOffersTheExamples()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        open(page);
        QTRY_VERIFY_WITH_TIMEOUT(shows(page, QStringLiteral("No types in this library yet")),
                                 test::longEnough_ms);
        auto* load = page.findChild<QPushButton*>(QStringLiteral("loadExampleTypes"));
        QTRY_VERIFY_WITH_TIMEOUT(load->isVisible(), test::longEnough_ms);
        QTest::mouseClick(load, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(page.view()->content().points.size(), std::size_t(40), test::longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        QCOMPARE(page.view()->content().ellipsoids.size(), std::size_t(4));
        QVERIFY(!shows(page, QStringLiteral("No types in this library yet")));
    }
    void simulatedPartsAreOfferedBesideThem()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        open(page);
        auto* load = page.findChild<QPushButton*>(QStringLiteral("loadSimulatedTypes"));
        QTRY_VERIFY_WITH_TIMEOUT(load->isVisible(), test::longEnough_ms);
        QTest::mouseClick(load, Qt::LeftButton);
        QVERIFY(!load->isEnabled()); // they are being squeezed
        QTRY_COMPARE_WITH_TIMEOUT(page.view()->content().points.size(), std::size_t(36), test::longEnough_ms);
        QTRY_COMPARE_WITH_TIMEOUT(page.view()->content().ellipsoids.size(), std::size_t(6),
                                  test::longEnough_ms);
    }
    void typesCanBeHidden()
    {
        test::PageFixture fixture;
        QVERIFY(fixture.loadExamples());
        TypesPage page(fixture.bench);
        open(page);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
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
        openPaper(page);
        QVERIFY(!page.clusters()->isVisibleTo(&page));
        click(button(page, QStringLiteral("Clusters")));
        QVERIFY(page.clusters()->isVisibleTo(&page));
        QCOMPARE(page.findChild<ClusterTableModel*>()->rowCount(), 10);
        QVERIFY(shows(page, QStringLiteral("Table 1")));
        QVERIFY(shows(page, QStringLiteral("1.000")));   // adjusted Rand index
        QVERIFY(shows(page, QStringLiteral("3.14529"))); // inertia of the z-scores
        QCOMPARE(page.view()->content().axes[2].title(), QStringLiteral("Stiffness k (as printed)"));
        click(button(page, QStringLiteral("Types")));
        QVERIFY(!page.clusters()->isVisibleTo(&page));
        QVERIFY(page.view()->content().centroids.empty());
    }
    void everyMethodIsSteppedThroughByClicks_data()
    {
        QTest::addColumn<int>("entry");
        QTest::addColumn<QString>("number");
        QTest::newRow("K-means") << 0 << QStringLiteral("Inertia");
        QTest::newRow("mixture, tied") << 1 << QStringLiteral("Log-likelihood");
        QTest::newRow("mixture, full") << 2 << QStringLiteral("BIC");
        QTest::newRow("map") << 3 << QStringLiteral("Topographic error");
    }
    void everyMethodIsSteppedThroughByClicks()
    {
        QFETCH(int, entry);
        QFETCH(QString, number);
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        openPaper(page);
        click(button(page, QStringLiteral("Clusters")));
        choose(page, "clusterMethod", entry);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady() && page.stepCount() >= 2, test::longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(shows(page, number), test::longEnough_ms);
        QVERIFY(shows(page, QStringLiteral("1.000"))); // all find the types
        const SceneContent& content = page.view()->content();
        QCOMPARE(content.ellipsoids.size(), std::size_t(entry == 1 || entry == 2 ? 4 : 0));
        QCOMPARE(content.net.has_value(), entry == 3);
        const QImage last = page.view()->picture();
        for (QToolButton* tool : page.findChildren<QToolButton*>())
            if (tool->accessibleName() == QStringLiteral("One iteration back"))
                click(tool);
        QVERIFY(shows(page,
                      QStringLiteral("step %1 of %2").arg(page.stepCount() - 2).arg(page.stepCount() - 1)) ||
                shows(page, QStringLiteral("start of")));
        page.showStep(0);
        QVERIFY(page.view()->picture() != last);
        int maps = 0;
        for (const HeatMap* map : page.findChildren<HeatMap*>())
            maps += map->isVisibleTo(&page) ? 1 : 0;
        QCOMPARE(maps, entry == 3 ? 4 : 0);
    }
    void pointingAtOnePlaneFramesTheUnitInAll()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        openPaper(page);
        click(button(page, QStringLiteral("Clusters")));
        choose(page, "clusterMethod", 3);
        QTRY_VERIFY_WITH_TIMEOUT(page.view()->content().net.has_value(), test::longEnough_ms);
        const auto maps = page.findChildren<HeatMap*>();
        QTest::keyClick(maps[1], Qt::Key_Right);
        for (const HeatMap* map : maps)
            QCOMPARE(map->marked(), 0);
    }
    void tooManyClustersAreRefusedInWords()
    {
        test::PageFixture fixture;
        QVERIFY(fixture.loadExamples());
        TypesPage page(fixture.bench);
        open(page);
        QTRY_VERIFY_WITH_TIMEOUT(page.stepCount() >= 2, test::longEnough_ms);
        click(button(page, QStringLiteral("Clusters")));
        auto* count = page.findChild<QSpinBox*>(QStringLiteral("clusterCount"));
        QCOMPARE(count->value(), 4);
        count->setValue(50);
        QTRY_VERIFY_WITH_TIMEOUT(shows(page, QStringLiteral("50 clusters need at least 50 squeezes")),
                                 test::longEnough_ms);
        QCOMPARE(page.stepCount(), 0);
        QCOMPARE(page.view()->content().points.size(), std::size_t(40)); // the types stay in view
        count->setValue(3);
        QTRY_VERIFY_WITH_TIMEOUT(page.stepCount() >= 2, test::longEnough_ms);
        QCOMPARE(page.view()->content().centroids.size(), std::size_t(3));
    }
    void anAnswerToAnOlderQuestionIsDropped()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        openPaper(page);
        click(button(page, QStringLiteral("Clusters")));
        page.clusters()->setClusters(7);
        page.clusters()->setClusters(2);
        page.clusters()->setMethod(ClusterMethod::GaussianMixture);
        page.clusters()->setClusters(3);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        for (int i = 0; i < 20; ++i)
            QTest::qWait(10);
        QCOMPARE(page.view()->content().ellipsoids.size(), std::size_t(3));
    }
    void adviceIsGivenOnRequestAndCanBeTaken()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        openPaper(page);
        click(button(page, QStringLiteral("Clusters")));
        page.clusters()->setClusters(2);
        auto* model = page.findChild<AdviceTableModel*>();
        QCOMPARE(model->rowCount(), 0);
        click(button(page, QStringLiteral("How many clusters")));
        QTRY_COMPARE_WITH_TIMEOUT(model->rowCount(), 8, test::longEnough_ms);
        QVERIFY(shows(page, QStringLiteral("4 groups")));
        click(button(page, QStringLiteral("Use 4")));
        QCOMPARE(page.clusters()->request().clusters, 4);
        // Another scaling asks a different question: the old answer goes, a new one comes.
        choose(page, "clusterScaling", 0);
        QCOMPARE(model->rowCount(), 0);
        QTRY_COMPARE_WITH_TIMEOUT(model->rowCount(), 8, test::longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
    }
    void adviceCanBeCancelled()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        openPaper(page);
        click(button(page, QStringLiteral("Clusters")));
        click(button(page, QStringLiteral("How many clusters")));
        click(button(page, QStringLiteral("Cancel")));
        QTRY_VERIFY_WITH_TIMEOUT(findButton(page, QStringLiteral("How many clusters")), test::longEnough_ms);
        QCOMPARE(page.findChild<AdviceTableModel*>()->rowCount(), 0);
    }
    void stepsWalkTheIterations()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        open(page);
        page.showPaper(true);
        QTRY_VERIFY_WITH_TIMEOUT(page.stepCount() >= 2, test::longEnough_ms);
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
                                 test::longEnough_ms);
        QTest::keyClick(page.view(), Qt::Key_N);
        QVERIFY(shows(page, QStringLiteral("A, squeeze 1\nm 0.0368")));
    }
    void squeezesAppearAsTheyAreEnrolled()
    {
        test::PageFixture fixture;
        TypesPage page(fixture.bench);
        open(page);
        enrol(fixture, QStringLiteral("Cola"));
        QTRY_COMPARE_WITH_TIMEOUT(page.view()->content().points.size(), std::size_t(1), test::longEnough_ms);
        QVERIFY(shows(page, QStringLiteral("With one squeeze a type nothing is known")));
        QVERIFY(page.view()->content().ellipsoids.empty());
        click(button(page, QStringLiteral("Clusters")));
        QTRY_VERIFY_WITH_TIMEOUT(shows(page, QStringLiteral("Clusters need at least two squeezes")),
                                 test::longEnough_ms);
        click(button(page, QStringLiteral("Types")));
        for (int n = 2; n <= 3; ++n) {
            enrol(fixture, QStringLiteral("Cola"));
            QTRY_COMPARE_WITH_TIMEOUT(page.view()->content().points.size(), std::size_t(n),
                                      test::longEnough_ms);
        }
        QVERIFY(!shows(page, QStringLiteral("With one squeeze a type nothing is known")));
        QTest::keyClick(page.view(), Qt::Key_N);
        QVERIFY(shows(page, QStringLiteral("Cola, squeeze 1\nm 40")));
        QVERIFY(shows(page, QStringLiteral("±"))); // its error is known
        QVERIFY(button(page, QStringLiteral("Open in Fit")));
    }
    void aNewInspectionIsRinged()
    {
        test::PageFixture fixture;
        QVERIFY(fixture.loadExamples());
        TypesPage page(fixture.bench);
        open(page);
        QTRY_VERIFY_WITH_TIMEOUT(page.tourReady(), test::longEnough_ms);
        QTRY_COMPARE_WITH_TIMEOUT(fixture.bench.inspection().state(), InspectSession::State::Ready,
                                  test::longEnough_ms);
        QVERIFY(fixture.bench.inspection().judgeRecording(simulatedSqueeze(test::canA, 6),
                                                          QStringLiteral("test")));
        QTRY_VERIFY_WITH_TIMEOUT(page.view()->content().highlight.has_value(), test::longEnough_ms);
        const SceneHighlight& highlight = *page.view()->content().highlight;
        QVERIFY(std::abs(highlight.point.at.z() / test::canA.k - 1) < 0.01);
        QVERIFY(highlight.ellipsoid);
    }
};

GRIPSCOPE_TEST(TypesPageTest)
#include "types_page_test.moc"
