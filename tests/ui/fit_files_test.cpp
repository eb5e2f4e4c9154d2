// SPDX-License-Identifier: GPL-3.0-or-later
// Several recordings at once on the Fit page.
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "tests/ui/science_pages.h"
#include "ui/imports/foreign_table_dialog.h"
#include "ui/pages/fit/fit_page.h"
#include "ui/pages/fit/opened_recordings.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QToolButton>
#include <QUrl>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

struct OpenedTogether {
    test::PageFixture fixture;
    FitPage page{fixture.bench};
    OpenedRecordings* files = page.findChild<OpenedRecordings*>();

    OpenedTogether()
    {
        page.resize(1200, 800);
        page.show();
    }
    QString recording(const QString& name, std::uint64_t seed)
    {
        const QString file = fixture.folder.filePath(name);
        if (!writeRecordingCsv(simulatedSqueeze(test::canA, seed), file))
            qFatal("not written");
        return file;
    }
    /// 0.csv to 3.csv
    void openFour()
    {
        QStringList all;
        for (int i = 0; i < 4; ++i)
            all << recording(u"%1.csv"_s.arg(i), std::uint64_t(i + 1));
        page.openRecordings(all);
    }
    QString foreign(const QString& name, std::uint64_t seed)
    {
        const Recording squeeze = simulatedSqueeze(test::canA, seed);
        QFile out(fixture.folder.filePath(name));
        if (!out.open(QIODevice::WriteOnly))
            qFatal("not written");
        out.write("t,push,way\ns,N,m\n");
        for (std::size_t i = 0; i < squeeze.size(); ++i)
            out.write(QByteArray::number(squeeze.time_s[i], 'g', 17) + ',' +
                      QByteArray::number(squeeze.force[i], 'g', 17) + ',' +
                      QByteArray::number(squeeze.position[i], 'g', 17) + '\n');
        return out.fileName();
    }
    QString title()
    {
        const auto& subject = fixture.bench.navigator().fitSubject();
        return subject ? subject->title : QString();
    }
    QString place() const { return files->isVisible() ? files->findChild<QLabel*>()->text() : QString(); }
    bool allRead() const
    {
        return QTest::qWaitFor([this] { return !files->isReading(); }, test::longEnough_ms);
    }
    QToolButton* arrow(bool next) const { return files->findChildren<QToolButton*>()[next ? 1 : 0]; }
    ForeignTableDialog* dialog() const
    {
        for (auto* one : page.findChildren<ForeignTableDialog*>())
            if (one->isVisible())
                return one;
        return nullptr;
    }
};

} // namespace

class FitFilesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void theFirstIsShownAndTheOthersAreAnArrowAway()
    {
        OpenedTogether opened;
        const QStringList all{opened.recording(u"a.csv"_s, 1), opened.recording(u"b.csv"_s, 2),
                              opened.recording(u"c.csv"_s, 3)};
        opened.page.openRecordings(all);
        QVERIFY(opened.allRead());
        QCOMPARE(opened.title(), u"a.csv"_s);
        QCOMPARE(opened.place(), u"1 of 3"_s);
        QVERIFY(!opened.arrow(false)->isEnabled());
        QTest::mouseClick(opened.arrow(true), Qt::LeftButton);
        QCOMPARE(opened.title(), u"b.csv"_s);
        QTest::keyClick(&opened.page, Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(opened.title(), u"c.csv"_s);
        QCOMPARE(opened.place(), u"3 of 3"_s);
        QVERIFY(!opened.arrow(true)->isEnabled());
        QTest::keyClick(&opened.page, Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(opened.title(), u"b.csv"_s);
        QVERIFY(opened.page.tourReady()); // identified beforehand
    }
    void oneFileHasNoArrows()
    {
        OpenedTogether opened;
        opened.page.openRecordings({opened.recording(u"a.csv"_s, 1)});
        QVERIFY(opened.allRead());
        QCOMPARE(opened.title(), u"a.csv"_s);
        QVERIFY(!opened.files->isVisible());
    }
    void aFileThatCannotBeReadIsNamedAndTheOthersAreRead()
    {
        OpenedTogether opened;
        opened.page.openRecordings({opened.recording(u"a.csv"_s, 1),
                                    opened.fixture.folder.filePath(u"absent.csv"_s),
                                    opened.recording(u"c.csv"_s, 3)});
        QVERIFY(opened.allRead());
        QCOMPARE(opened.place(), u"1 of 2"_s);
        QCOMPARE(opened.fixture.reports.size(), 1);
        QVERIFY(opened.fixture.reports.first().first().toString().contains(u"absent.csv"_s));
    }
    void tablesOfOneLayoutAreAskedAboutOnce()
    {
        OpenedTogether opened;
        opened.page.openRecordings({opened.foreign(u"x.csv"_s, 1), opened.foreign(u"y.csv"_s, 2)});
        QVERIFY(QTest::qWaitFor([&] { return opened.dialog() != nullptr; }, test::longEnough_ms));
        QTest::mouseClick(opened.dialog()->findChild<QPushButton*>(u"importTable"_s), Qt::LeftButton);
        QVERIFY(opened.allRead());
        QVERIFY(!opened.dialog());
        QCOMPARE(opened.place(), u"1 of 2"_s);
        // Opened alone, it is asked about again: what was said before may be what is wrong.
        opened.page.openRecordings({opened.fixture.folder.filePath(u"x.csv"_s)});
        QVERIFY(QTest::qWaitFor([&] { return opened.dialog() != nullptr; }, test::longEnough_ms));
    }
    void droppedTogetherTheyAreOpenedTogether()
    {
        OpenedTogether opened;
        QMimeData dropped;
        dropped.setUrls({QUrl::fromLocalFile(opened.recording(u"a.csv"_s, 1)),
                         QUrl(u"https://example.com/b.csv"_s),
                         QUrl::fromLocalFile(opened.recording(u"c.csv"_s, 3))});
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &dropped, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&opened.page, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop({10, 10}, Qt::CopyAction, &dropped, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&opened.page, &drop);
        QVERIFY(opened.allRead());
        QCOMPARE(opened.place(), u"1 of 2"_s);
    }
    void anArrowDoesNotLoseWhatIsStillRead()
    {
        OpenedTogether opened;
        opened.openFour();
        QVERIFY(QTest::qWaitFor([&] { return !opened.place().isEmpty(); }, test::longEnough_ms));
        QTest::mouseClick(opened.arrow(true), Qt::LeftButton);
        QVERIFY(opened.allRead());
        QCOMPARE(opened.place(), u"2 of 4"_s);
    }
    void cancelLeavesThoseThatWereRead()
    {
        OpenedTogether opened;
        opened.openFour();
        QVERIFY(QTest::qWaitFor([&] { return opened.title() == u"0.csv"_s; }, test::longEnough_ms));
        auto* cancel = opened.page.findChild<QPushButton*>(u"identifyAgain"_s);
        QTRY_COMPARE_WITH_TIMEOUT(cancel->text(), u"Cancel"_s, test::longEnough_ms);
        QTest::mouseClick(cancel, Qt::LeftButton);
        QVERIFY(opened.allRead());
        QCOMPARE(cancel->text(), u"Identify again"_s);
        QVERIFY(opened.place() != u"1 of 4"_s);
        QCOMPARE(opened.title(), u"0.csv"_s);
    }
    void anotherSqueezeTakesTheArrowsAway()
    {
        OpenedTogether opened;
        opened.page.openRecordings({opened.recording(u"a.csv"_s, 1), opened.recording(u"b.csv"_s, 2)});
        QVERIFY(opened.allRead());
        QVERIFY(opened.files->isVisible());
        const Recording recording = simulatedSqueeze(test::canA, 7);
        opened.fixture.bench.navigator().setFitSubject({u"Inspection 1"_s, recording, identify(recording)});
        QVERIFY(!opened.files->isVisible());
    }
};

GRIPSCOPE_TEST(FitFilesTest)
#include "fit_files_test.moc"
