// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/shell/tour.h"

#include <QDir>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;

class TourTest : public QObject {
    Q_OBJECT
private slots:
    void savesOnePictureAPage();
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
    QCOMPARE(runTour(options), 0);
    QStringList names = QDir(options.folder).entryList({u"*.png"_s}, QDir::Files, QDir::Name);
    QCOMPARE(names, (QStringList{u"calibrate.png"_s, u"enroll.png"_s, u"fit.png"_s, u"history.png"_s,
                                 u"inspect.png"_s, u"live.png"_s, u"types.png"_s}));
    for (const QString& name : names) {
        const QImage picture(QDir(options.folder).filePath(name));
        QCOMPARE(picture.size(), options.size);
        // Something is on it: not one colour from edge to edge below the header.
        QSet<QRgb> colors;
        for (int y = 80; y < picture.height() - 40; y += 7)
            for (int x = 100; x < picture.width(); x += 7)
                colors << picture.pixel(x, y);
        QVERIFY2(colors.size() > 8, qPrintable(name));
    }
    Theme::instance().apply(ThemeKind::Light);
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
