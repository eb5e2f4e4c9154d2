// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/shell/tour.h"

#include <QColor>
#include <QDir>
#include <QHash>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace Qt::StringLiterals;
using namespace gripscope;

class TourTest : public QObject {
    Q_OBJECT
private slots:
    void savesOnePictureAPage();
    void thereIsNoPictureOfAPageThatWasNotReady();
    void aFolderThatCannotBeMadeIsAnError();
    void theProgramRefusesWhatItDoesNotKnow_data();
    void theProgramRefusesWhatItDoesNotKnow();
};

void TourTest::savesOnePictureAPage()
{
    QTemporaryDir folder;
    TourOptions options;
    options.folder = folder.filePath(u"pictures"_s);
    options.theme = ThemeKind::Dark;
    options.size = {1024, 640};
    options.patience = test::patience;
    QCOMPARE(runTour(options), 0);
    QStringList names = QDir(options.folder).entryList({u"*.png"_s}, QDir::Files, QDir::Name);
    QCOMPARE(names, (QStringList{u"calibrate.png"_s, u"enroll.png"_s, u"fit.png"_s, u"history.png"_s,
                                 u"inspect.png"_s, u"live.png"_s, u"quality.png"_s, u"types.png"_s}));
    for (const QString& name : names) {
        const QImage picture(QDir(options.folder).filePath(name));
        QCOMPARE(picture.size(), options.size);
        // Something is on it that can be read: not one colour from edge to edge below the header, and not
        // shades of it.
        QHash<QRgb, int> colors;
        int points = 0;
        for (int y = 80; y < picture.height() - 40; y += 3)
            for (int x = 100; x < picture.width(); x += 3, ++points)
                ++colors[picture.pixel(x, y)];
        const auto ground = std::max_element(colors.begin(), colors.end());
        QVERIFY2(ground.value() < 0.98 * points, qPrintable(name));
        int ink = 0;
        for (auto one = colors.cbegin(); one != colors.cend(); ++one)
            if (Theme::contrastRatio(QColor(one.key()), QColor(ground.key())) >= 3)
                ink += one.value();
        QVERIFY2(ink > 0.003 * points, qPrintable(name));
        QVERIFY2(colors.size() > 40, qPrintable(name)); // letters have soft edges
    }
    Theme::instance().apply(ThemeKind::Light);
}

void TourTest::thereIsNoPictureOfAPageThatWasNotReady()
{
    QTemporaryDir folder;
    TourOptions options;
    options.folder = folder.path();
    options.patience = std::chrono::milliseconds(0);
    QCOMPARE(runTour(options), 1);
    // These take squeezes, which no computer does in no time.
    for (const QString& name : {u"live.png"_s, u"inspect.png"_s, u"enroll.png"_s, u"history.png"_s})
        QVERIFY2(!QFile::exists(folder.filePath(name)), qPrintable(name));
}

void TourTest::aFolderThatCannotBeMadeIsAnError()
{
    TourOptions options;
    options.folder = u"/proc/no/such/folder"_s;
    QCOMPARE(runTour(options), 1);
}

void TourTest::theProgramRefusesWhatItDoesNotKnow_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("theme") << QStringList{u"--theme"_s, u"pink"_s};
    QTest::newRow("size") << QStringList{u"--size"_s, u"big"_s};
    QTest::newRow("scale") << QStringList{u"--scale"_s, u"9"_s};
    QTest::newRow("language") << QStringList{u"--language"_s, u"tlh"_s};
    QTest::newRow("option") << QStringList{u"--turbo"_s};
    QTest::newRow("word") << QStringList{u"recording.csv"_s};
}

void TourTest::theProgramRefusesWhatItDoesNotKnow()
{
    QFETCH(QStringList, arguments);
    QProcess program;
    program.start(QStringLiteral(GRIPSCOPE_BIN_DIR) + u"/gripscope"_s, arguments);
    QVERIFY(program.waitForFinished(30000));
    QCOMPARE(program.exitCode(), 2);
    QVERIFY(program.readAllStandardError().contains("gripscope: "));
}

GRIPSCOPE_TEST(TourTest)
#include "tour_test.moc"
