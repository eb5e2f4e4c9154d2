// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/format/date_text.h"
#include "ui/reports/letterhead.h"
#include "ui/reports/reports.h"
#include "ui/settings/values/settings.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QTimeZone>

using namespace gripscope;
using namespace Qt::StringLiterals;

/// Whose report it is, and when it was made.
class LetterheadTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;

    QString fileWith(const QString& name, const QByteArray& bytes)
    {
        QFile file(m_folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("no file");
        return file.fileName();
    }

private slots:
    void itComesFromTheSettings()
    {
        Settings settings;
        QCOMPARE(letterheadHtml(readLetterhead(letterheadSource(settings)).value()), QString());
        settings.set(setting::company, u"Müller & Söhne"_s);
        settings.set(setting::companyAddress, u"Hafenstr. 1; 20457 Hamburg ;"_s);
        QImage image(300, 100, QImage::Format_ARGB32);
        image.fill(Qt::blue);
        const QString logo = m_folder.filePath(u"logo.png"_s);
        QVERIFY(image.save(logo));
        settings.set(setting::companyLogo, logo);
        const Letterhead head = readLetterhead(letterheadSource(settings)).value();
        QCOMPARE(head.address, QStringList({u"Hafenstr. 1"_s, u"20457 Hamburg"_s}));
        QCOMPARE(head.logo.size(), QSize(300, 100));
        const QString html = letterheadHtml(head);
        QVERIFY(html.contains(u"Müller &amp; Söhne"_s) && html.contains(u"20457 Hamburg"_s));
        QCOMPARE(letterheadPictures(head).size(), std::size_t(1));
        QVERIFY(html.contains(letterheadPictures(head).front().name));
        QVERIFY(historyReportHtml({}, head).startsWith(html)); // on every report
    }
    void aDrawingIsALogoToo()
    {
        const QString plain =
            fileWith(u"logo.svg"_s,
                     "<?xml version='1.0'?><svg xmlns='http://www.w3.org/2000/svg' width='40' height='20'>"
                     "<rect width='40' height='20' fill='#ff0000'/></svg>");
        const auto head = readLetterhead({{}, {}, plain});
        QVERIFY(head);
        QCOMPARE(head->logo.width(), 2 * head->logo.height());
        QCOMPARE(head->logo.pixelColor(head->logo.width() / 2, head->logo.height() / 2), QColor(255, 0, 0));
    }
    void whatIsNoPlainLogoIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const QByteArray svg = "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='20'>";
        QTest::newRow("reads a file")
            << svg + "<image href='file:///etc/passwd' width='9' height='9'/></svg>";
        QTest::newRow("repeats itself") << svg + "<g id='a'/><use href='#a'/></svg>";
        QTest::newRow("entities") << "<!DOCTYPE svg [<!ENTITY a 'aaaa'>]>" + svg + "&a;</svg>";
        QTest::newRow("style sheet") << "<?xml-stylesheet href='x.css'?>" + svg + "</svg>";
        QTest::newRow("cut off") << svg + "<rect";
        QTest::newRow("text") << QByteArray("my logo");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("no picture behind its head") << QByteArray("\x89PNG\r\n\x1a\n nothing");
        QTest::newRow("too long") << QByteArray(mostLogoBytes + 1, ' ');
    }
    void whatIsNoPlainLogoIsRefused()
    {
        QFETCH(QByteArray, bytes);
        const auto head = readLetterhead({u"Us"_s, {}, fileWith(u"bad"_s, bytes)});
        QVERIFY(!head);
        QCOMPARE(head.error().code, ErrorCode::FileUnreadable);
    }
    void aPngOfTooManyPixelsIsNotUnpacked()
    {
        QImage wide(mostLogoSide + 1, 1, QImage::Format_Mono);
        wide.fill(0);
        const QString file = m_folder.filePath(u"wide.png"_s);
        QVERIFY(wide.save(file));
        QVERIFY(!readLetterhead({{}, {}, file}));
        QVERIFY(!readLetterhead({{}, {}, m_folder.filePath(u"none.png"_s)}));
    }
    void timesCarryTheirYearAndWhatLeavesTheStationItsZone()
    {
        const QDateTime time(QDate(2026, 11, 22), QTime(9, 50, 31));
        QCOMPARE(dateText(time), u"2026-11-22"_s);
        QCOMPARE(timeText(time), u"2026-11-22 09:50"_s);
        QCOMPARE(exactTimeText(time), u"2026-11-22 09:50:31"_s);
        const int minutes = std::abs(time.offsetFromUtc()) / 60;
        const QString zone = u"UTC%1%2:%3"_s.arg(time.offsetFromUtc() < 0 ? u"−"_s : u"+"_s)
                                 .arg(minutes / 60, 2, 10, QChar(u'0'))
                                 .arg(minutes % 60, 2, 10, QChar(u'0'));
        QCOMPARE(zonedTimeText(time), u"2026-11-22 09:50 "_s + zone);
        QCOMPARE(zonedTimeText(time.toUTC()), zonedTimeText(time)); // the same moment, in the station's zone
        QCOMPARE(zonedTimeText({}), u"–"_s);
        HistoryReport report;
        report.made = time;
        QVERIFY(historyReportHtml(report).contains(zonedTimeText(time)));
    }
};

GRIPSCOPE_TEST(LetterheadTest)
#include "letterhead_test.moc"
