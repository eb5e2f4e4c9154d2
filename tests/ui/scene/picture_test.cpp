// SPDX-License-Identifier: GPL-3.0-or-later
// The pages look as the kept pictures show them; those of the light theme are the manual's, which so never
// get stale. packaging/keep_pictures.sh makes them anew, to be looked at before they are committed.
#include "tests/support/test_registry.h"
#include "tests/ui/scene/picture_comparison.h"
#include "ui/context/language.h"
#include "ui/shell/tour.h"

#include <QDir>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::differingShare;

class PictureTest : public QObject {
    Q_OBJECT

    static QString kept(const QString& theme, const QString& language = u"en"_s)
    {
        const QString source = QStringLiteral(GRIPSCOPE_SOURCE_DIR);
        if (theme != u"light")
            return source + u"/tests/data/pictures/"_s + theme;
        return source + (language == u"en" ? u"/resources/manual/pictures"_s
                                           : u"/resources/manual/%1/pictures"_s.arg(language));
    }
    /// What may differ from run to run: a strip chart is caught at another moment, figures read otherwise.
    static double tolerance(const QString& page)
    {
        return page == u"live.png" || page == u"fit.png" ? 0.12 : 0.05;
    }

private slots:
    void thePagesLookAsTheyDid_data()
    {
        QTest::addColumn<QString>("theme");
        QTest::addColumn<QString>("language");
        for (const char* theme : {"light", "dark", "contrast"})
            QTest::newRow(theme) << QString::fromLatin1(theme) << u"en"_s;
        QTest::newRow("German") << u"light"_s << u"de"_s;
    }
    void thePagesLookAsTheyDid()
    {
        QFETCH(QString, theme);
        QFETCH(QString, language);
        QTemporaryDir folder;
        TourOptions options;
        options.folder = folder.path();
        options.theme = *themeKindFromString(theme);
        options.language = language;
        options.size = {1024, 640};
        options.patience = test::patience;
        QCOMPARE(runTour(options), 0);
        Theme::instance().apply(ThemeKind::Light);
        QVERIFY(applyLanguage(u"en"_s));
        const QStringList made = QDir(folder.path()).entryList({u"*.png"_s}, QDir::Files, QDir::Name);
        QCOMPARE(made, QDir(kept(theme, language)).entryList({u"*.png"_s}, QDir::Files, QDir::Name));
        QStringList others;
        for (const QString& name : made) {
            const double share =
                differingShare(QImage(folder.filePath(name)), QImage(kept(theme, language) + u'/' + name));
            qInfo("%s %s %s: %.1f %%", qPrintable(theme), qPrintable(language), qPrintable(name),
                  100 * share);
            if (share > tolerance(name))
                others << name;
        }
        QVERIFY2(others.isEmpty(), qPrintable(others.join(u' ')));
    }
    /// The least window: one that a message had made higher is not how the page looks.
    void everyKeptOneHasTheLeastSize_data() { thePagesLookAsTheyDid_data(); }
    void everyKeptOneHasTheLeastSize()
    {
        QFETCH(QString, theme);
        QFETCH(QString, language);
        const QDir folder(kept(theme, language));
        const QStringList names = folder.entryList({u"*.png"_s}, QDir::Files);
        QCOMPARE(names.size(), 8);
        QStringList others;
        for (const QString& name : names)
            if (const QSize size = QImage(folder.filePath(name)).size(); size != QSize(1024, 640))
                others << u"%1: %2 x %3"_s.arg(name).arg(size.width()).arg(size.height());
        QVERIFY2(others.isEmpty(), qPrintable(others.join(u", "_s)));
    }
    void whatMovedOrWentIsTold()
    {
        for (const QString& name : QDir(kept(u"light"_s)).entryList({u"*.png"_s}, QDir::Files)) {
            const QImage picture =
                QImage(kept(u"light"_s) + u'/' + name).convertToFormat(QImage::Format_RGB32);
            QCOMPARE(differingShare(picture, picture), 0.0);
            QImage moved = picture;
            QImage recoloured = picture;
            QPainter(&moved).drawImage(88 + 32, 64 + 32, picture, 88,
                                       64); // the page, not the rail and header
            recoloured.invertPixels();
            QVERIFY2(differingShare(picture, moved) > tolerance(name), qPrintable(name));
            QVERIFY2(differingShare(picture, recoloured) > 0.5, qPrintable(name));
        }
    }
};

GRIPSCOPE_TEST(PictureTest)
#include "picture_test.moc"
