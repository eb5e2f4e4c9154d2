// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/library/history_document.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"

#include <QMap>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// A small reader of the ASCII transfer format, by its published structure alone: K-fields of the form
/// "Knnnn/characteristic value" up to the first line that is none, then value lines with char 15 between the
/// characteristics and char 20 between the fields of each.
struct AqdefFile {
    QMap<QString, QString> fields; ///< "K2001/1"
    QList<QList<QStringList>> values;
    QString problem;

    explicit AqdefFile(const QByteArray& bytes)
    {
        if (!bytes.startsWith("K0100 "))
            problem = u"K0100 is not first"_s;
        if (!bytes.endsWith("\r\n"))
            problem = u"the last line does not end"_s;
        for (const QString& line : QString::fromLatin1(bytes).split(u"\r\n"_s, Qt::SkipEmptyParts))
            take(line);
    }

private:
    void take(const QString& line)
    {
        if (line.startsWith(u'K') && line.size() > 5 && line[1].isDigit()) {
            if (!values.isEmpty())
                problem = u"a field behind the values: "_s + line;
            fields.insert(line.section(u' ', 0, 0), line.section(u' ', 1));
            return;
        }
        QList<QStringList> part;
        for (const QString& characteristic : line.split(QChar(15)))
            part << characteristic.split(QChar(20));
        if (part.size() != fields.value(u"K0100"_s).toInt())
            problem = u"another number of characteristics: "_s + line;
        values << part;
    }
};

HistoryEntry someEntry(const QString& type, double k)
{
    HistoryEntry entry;
    entry.time = QDateTime(QDate(2026, 3, 1), QTime(10, 42, 7), Qt::UTC);
    entry.type = type;
    entry.validity = ValidityVerdict::Valid;
    entry.parameters = MassDampingStiffness{4e-5, 0.043, k}; // N s²/mm, N s/mm, N/mm
    entry.forceUnit = u"N"_s;
    entry.positionUnit = u"mm"_s;
    entry.operatorName = u"Jörg"_s;
    entry.station = u"st-1"_s;
    entry.device = u"Gripper"_s;
    entry.serial = u"G-7"_s;
    entry.batch = u"B\x14 9"_s;
    return entry;
}

AqdefFile fileOf(const std::vector<HistoryEntry>& entries, const TypeRecord* type = nullptr)
{
    AqdefCatalogue catalogue;
    catalogue.add(entries);
    return AqdefFile(catalogue.head(type) + catalogue.lines(entries));
}

} // namespace

class HistoryAqdefTest : public QObject {
    Q_OBJECT
private slots:
    void anotherReaderFindsPartsAndValues()
    {
        HistoryEntry other = someEntry(u"can"_s, 11);
        other.operatorName = u"Ada"_s;
        other.serial = u"G-8"_s;
        const AqdefFile file = fileOf({someEntry(u"can"_s, 10), other});
        QVERIFY2(file.problem.isEmpty(), qPrintable(file.problem));
        QCOMPARE(file.fields[u"K0100"_s], u"3"_s);
        QCOMPARE(file.fields[u"K1001"_s], u"can"_s);
        QCOMPARE(file.fields[u"K2001/3"_s], u"3"_s);
        QCOMPARE(file.fields[u"K2002/3"_s], u"stiffness k"_s);
        QCOMPARE(file.fields[u"K2142/1"_s], u"kg"_s);
        QCOMPARE(file.fields[u"K2142/3"_s], u"N/m"_s);
        QCOMPARE(file.fields[u"K4092/1"_s], u"Jörg"_s);
        QCOMPARE(file.fields[u"K4072/2"_s], u"Gripper G-8"_s);
        QVERIFY(!file.fields.contains(u"K2110/3"_s));
        QCOMPARE(file.values.size(), 2);
        const QStringList k = file.values[1][2];
        QCOMPARE(k.size(), 10);
        QCOMPARE(k[0].toDouble(), 11000.0);
        QCOMPARE(k[1], u"0"_s);
        QCOMPARE(k[2], u"01.03.2026/10:42:07"_s);
        QCOMPARE(k[5], u"0"_s);    // a number, or some readers stop
        QCOMPARE(k[4], u"#B 9"_s); // what would part fields is none
        QCOMPARE((QStringList{k[6], k[7], k[9]}), (QStringList{u"2"_s, u"1"_s, u"2"_s}));
        QCOMPARE(file.values[0][0][0].toDouble(), 0.04);
    }
    void whatDoesNotCountIsMarked_data()
    {
        QTest::addColumn<int>("how");
        QTest::newRow("not valid") << 0;
        QTest::newRow("voided") << 1;
        QTest::newRow("not measured") << 2;
        QTest::newRow("units not known") << 3;
        QTest::newRow("dropped from its type") << 4;
    }
    void whatDoesNotCountIsMarked()
    {
        QFETCH(int, how);
        HistoryEntry entry = someEntry(u"can"_s, 10);
        if (how == 0)
            entry.validity = ValidityVerdict::Invalid;
        else if (how == 1)
            entry.voided = u"wrong part"_s;
        else if (how == 2)
            entry.parameters.reset();
        else if (how == 3)
            entry.forceUnit = u"counts"_s;
        else
            entry.accepted = false;
        const AqdefFile file = fileOf({entry, someEntry(u"can"_s, 11)});
        QVERIFY2(file.problem.isEmpty(), qPrintable(file.problem));
        for (const QStringList& fields : file.values[0])
            QCOMPARE(fields[1], u"255"_s);
        QCOMPARE(file.values[1][0][1], u"0"_s);
    }
    void limitsAreThoseOfTheOneTypeInSi()
    {
        TypeRecord type;
        type.name = u"can"_s;
        type.forceUnit = u"N"_s;
        type.positionUnit = u"mm"_s;
        type.limits.quantities[2] = ToleranceLimits{9.0, 12.0};
        type.limits.quantities[0] = ToleranceLimits{std::nullopt, 5e-5};
        const AqdefFile file = fileOf({someEntry(u"can"_s, 10)}, &type);
        QCOMPARE(file.fields[u"K2110/3"_s].toDouble(), 9000.0);
        QCOMPARE(file.fields[u"K2111/3"_s].toDouble(), 12000.0);
        QCOMPARE(file.fields[u"K2101/3"_s].toDouble(), 10500.0);
        QCOMPARE(file.fields[u"K2111/1"_s].toDouble(), 0.05);
        QVERIFY(!file.fields.contains(u"K2110/1"_s) && !file.fields.contains(u"K2101/1"_s));
    }
    void textsAreNoLongerThanTheFormatHasThem()
    {
        HistoryEntry entry = someEntry(QString(200, u't'), 10);
        entry.operatorName = QString(200, u'o');
        entry.station = QString(200, u's');
        entry.device = QString(200, u'g');
        entry.batch = QString(200, u'b');
        const AqdefFile file = fileOf({entry});
        QCOMPARE(file.fields[u"K1001"_s].size(), 30);
        QCOMPARE(file.fields[u"K4092/1"_s].size(), 50);
        QCOMPARE(file.fields[u"K4062/1"_s].size(), 40);
        QCOMPARE(file.fields[u"K4072/1"_s].size(), 40);
        QCOMPARE(file.values[0][0][4].size(), 14);
    }
    /// A chart of the values goes as the file goes, whatever the list on the screen is ordered by.
    void theOldestIsFirst()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        for (const double k : {3.0, 1.0, 2.0}) {
            NewInspection inspection = anInspection();
            inspection.grasp.estimates = {anEstimate(0.04, 43, k)};
            valueOf(library->addInspection(inspection));
            QTest::qWait(2); // another time
        }
        HistoryQuery query;
        query.order = HistoryColumn::Stiffness;
        HistoryDocument document(query, HistoryFormat::Aqdef);
        QByteArray bytes;
        while (!document.ended())
            bytes += valueOf(document.next(*library));
        const AqdefFile file(bytes);
        QCOMPARE(file.values.size(), 3);
        QCOMPARE((QStringList{file.values[0][2][0], file.values[1][2][0], file.values[2][2][0]}),
                 (QStringList{u"3"_s, u"1"_s, u"2"_s}));
    }
    void severalTypesAreVarious()
    {
        const AqdefFile file = fileOf({someEntry(u"can"_s, 10), someEntry(u"jar"_s, 10)});
        QCOMPARE(file.fields[u"K1001"_s], u"various"_s);
    }
};

GRIPSCOPE_TEST(HistoryAqdefTest)
#include "history_aqdef_test.moc"
