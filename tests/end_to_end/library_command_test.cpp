// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that look at whole libraries: tables that are enrolled, drift, transfer.
#include "core/library/library.h"
#include "core/library/records/gripper_adjustment.h"
#include "core/library/spill/inspection_spill.h"
#include "core/library/sql/time_ordered_id.h"
#include "core/math/gaussian.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFile>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// Rows of types A and B, 10 squeezes each with 3 % scatter, times a factor.
QByteArray tableOf(std::uint64_t seed, double factor)
{
    GaussianNoise noise(seed);
    QByteArray table = "object,m,b,k\n";
    for (int i = 0; i < 20; ++i) {
        const double base = i % 2 == 0 ? 1 : 2;
        table += i % 2 == 0 ? "A" : "B";
        for (int parameter = 0; parameter < 3; ++parameter)
            table += ',' + QByteArray::number(factor * base * std::exp(0.03 * noise()), 'g', 17);
        table += '\n';
    }
    return table;
}

/// Inspections of both types, as the table's second half, in newtons and metres.
void inspect(const QString& file, double factor)
{
    const auto library = Library::open(file);
    QVERIFY(library);
    GaussianNoise noise(7);
    for (int i = 0; i < 40; ++i) {
        const double base = factor * (i % 2 == 0 ? 1 : 2);
        const auto draw = [&] { return base * std::exp(0.03 * noise()); };
        Estimate estimate;
        estimate.status = EstimateStatus::Converged;
        const double m = draw(), b = draw(), k = draw();
        estimate.parameters = MassDampingStiffness{m, b, k};
        NewInspection inspection;
        inspection.grasp.estimates = {estimate};
        inspection.grasp.forceUnit = u"N"_s;
        inspection.grasp.positionUnit = u"m"_s;
        inspection.verdict.kind = VerdictKind::Unknown;
        inspection.expectedType = i % 2 == 0 ? u"A"_s : u"B"_s;
        QVERIFY((*library)->addInspection(inspection));
    }
}

/// Stores for a gripper that it finds `gain` times m, b and k of the one that the types were enrolled on;
/// known to 0.5 %. Its key.
QString acceptAdjustment(const QString& file, const QString& serial, const std::array<double, 3>& gain)
{
    NewAdjustment adjustment;
    adjustment.gripperSerial = serial;
    adjustment.error.value = Eigen::Vector3d(std::log(gain[0]), std::log(gain[1]), std::log(gain[2]));
    adjustment.error.covariance = Eigen::Matrix3d::Identity() * 0.005 * 0.005;
    adjustment.error.degreesOfFreedom = 20;
    adjustment.reason = u"second line"_s;
    const auto library = Library::open(file);
    const auto accepted = library ? (*library)->acceptAdjustment(adjustment)
                                  : Expected<AdjustmentRecord>(tl::unexpected(library.error()));
    return accepted ? accepted->id : QString();
}

const QStringList siUnits{u"--force-unit"_s, u"N"_s, u"--position-unit"_s, u"m"_s};

} // namespace

class LibraryCommandTest : public QObject {
    Q_OBJECT
private:
    ProgramRun enroll(const Workplace& work, const QString& library, const QString& table,
                      const QStringList& more = siUnits)
    {
        return work.cli(QStringList{u"enroll"_s, u"--library"_s, library, u"--table"_s, table,
                                    u"--type-column"_s, u"object"_s, u"--json"_s} +
                        more);
    }

private slots:
    void aTableIsEnrolledRowByRow()
    {
        const Workplace work;
        work.write(u"t.csv"_s, tableOf(1, 1) + "A,1,0,1\n,1,1,1\n");
        const ProgramRun run = enroll(work, u"t.db"_s, u"t.csv"_s);
        QCOMPARE(run.exit, 3);
        const QJsonObject document = run.json();
        QCOMPARE(document[u"added"].toArray().size(), 20);
        QCOMPARE(document[u"types"][0][u"added"].toInt(), 10);
        QCOMPARE(document[u"rejected"].toArray().size(), 2);
        QCOMPARE(document[u"rejected"][0][u"file"].toString(), u"t.csv:22"_s);
        QVERIFY(document[u"rejected"][0][u"reason"].toString().contains(u"t.csv:22:3"_s));
        // The same again adds nothing; numbers without units do not go with kilograms.
        const ProgramRun again = enroll(work, u"t.db"_s, u"t.csv"_s);
        QCOMPARE(again.exit, 3);
        QCOMPARE(again.json()[u"added"].toArray().size(), 0);
        work.write(u"u.csv"_s, "object,m,b,k\nC,1,1,1\nA,1,1,1\n");
        const ProgramRun unitless = enroll(work, u"t.db"_s, u"u.csv"_s, {});
        QCOMPARE(unitless.exit, 3);
        QCOMPARE(unitless.json()[u"rejected"].toArray().size(), 2);
        QCOMPARE(work.cli({u"enroll"_s, u"--library"_s, u"t.db"_s, u"--table"_s, u"u.csv"_s}).exit, 2);
        QCOMPARE(work.cli({u"enroll"_s, u"--library"_s, u"t.db"_s, u"--type"_s, u"A"_s}).exit, 2);
        QCOMPARE(enroll(work, u"t.db"_s, u"missing.csv"_s).exit, 3);
    }
    void driftOfTheSensorIsTold()
    {
        Workplace work;
        work.write(u"t.csv"_s, tableOf(1, 1));
        QCOMPARE(enroll(work, u"t.db"_s, u"t.csv"_s).exit, 0);
        const QStringList ask{u"drift"_s, u"--library"_s, u"t.db"_s};
        QCOMPARE(work.cli(ask + QStringList{u"--json"_s}).json()[u"cause"].toString(), u"too_few"_s);
        inspect(work.path(u"t.db"_s), 1.1);
        const ProgramRun run = work.cli(ask + QStringList{u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        QCOMPARE(document[u"cause"].toString(), u"sensor"_s);
        QCOMPARE(document[u"squeezes"].toInt(), 40);
        // 20 squeezes against 10, two types: 3 % sqrt((1/20 + 1/10) / 2) = 0.8 %; four times that.
        QVERIFY(std::abs(document[u"factor"][u"value"][u"m"].toDouble() - std::log(1.1)) < 0.033);
        QVERIFY(work.cli(ask).out.contains("calibration"));
        QCOMPARE(work.cli({u"drift"_s, u"--library"_s, u"none.db"_s}).exit, 5);
        QCOMPARE(work.cli(ask + QStringList{u"--weight"_s, u"2"_s}).exit, 2);
    }
    void theHistoryIsListedFilteredAndExported()
    {
        Workplace work;
        work.write(u"t.csv"_s, tableOf(1, 1));
        QCOMPARE(enroll(work, u"t.db"_s, u"t.csv"_s).exit, 0);
        inspect(work.path(u"t.db"_s), 1.1);
        const QStringList ask{u"history"_s, u"--library"_s, u"t.db"_s};
        const QJsonObject all = work.cli(ask + QStringList{u"--json"_s}).json();
        const qsizetype squeezes = all[u"squeezes"].toArray().size();
        QVERIFY(squeezes > 40);
        QCOMPARE(all[u"count"].toInt(), int(squeezes));
        const QStringList inspected = ask + QStringList{u"--kind"_s, u"inspection"_s};
        const QJsonObject some = work.cli(inspected + QStringList{u"--json"_s}).json();
        QCOMPARE(some[u"squeezes"].toArray().size(), 40);
        QCOMPARE(some[u"filter"][u"kind"].toString(), u"inspection"_s);
        QCOMPARE(work.cli(inspected + QStringList{u"--csv"_s}).out.count('\n'), 41);
        QCOMPARE(work.cli(inspected).out.count('\n'), 41);
        const auto worth = [&](const QString& validity) {
            return work.cli(ask + QStringList{u"--validity"_s, validity, u"--json"_s}).json();
        };
        QCOMPARE(worth(u"valid"_s)[u"count"].toInt(), 40);
        QCOMPARE(worth(u"suspect"_s)[u"count"].toInt(), 0);
        QCOMPARE(worth(u"suspect"_s)[u"filter"][u"validity"].toString(), u"suspect"_s);
        QCOMPARE(work.cli(ask + QStringList{u"--validity"_s, u"good"_s}).exit, 2);
        QCOMPARE(work.cli(inspected + QStringList{u"--csv"_s, u"--json"_s}).exit, 2);
        QCOMPARE(work.cli(ask + QStringList{u"--from"_s, u"yesterday"_s}).exit, 2);
        QCOMPARE(work.cli({u"history"_s, u"--library"_s, u"none.db"_s}).exit, 5);
    }
    void transferIsMeasuredAndAdjusted()
    {
        const Workplace work;
        work.write(u"here.csv"_s, tableOf(1, 1));
        work.write(u"there.csv"_s, tableOf(2, 1.25));
        QCOMPARE(enroll(work, u"here.db"_s, u"here.csv"_s).exit, 0);
        QCOMPARE(enroll(work, u"there.db"_s, u"there.csv"_s).exit, 0);
        const QStringList ask{u"transfer"_s, u"--library"_s, u"here.db"_s, u"there.db"_s};
        const ProgramRun run = work.cli(ask + QStringList{u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        QVERIFY(document[u"adjust"].toBool());
        // 10 squeezes against 10, two types: 0.95 %; four times that.
        QVERIFY(std::abs(document[u"factor"][u"k"].toDouble() * 1.25 - 1) < 0.04);
        QVERIFY(document[u"left_out_types"][u"named_after"].toInt() >= 18);
        QVERIFY(work.cli(ask).out.contains("helps: use it"));
        work.write(u"printed.csv"_s, tableOf(3, 1));
        QCOMPARE(enroll(work, u"printed.db"_s, u"printed.csv"_s, {}).exit, 0);
        QCOMPARE(work.cli({u"transfer"_s, u"--library"_s, u"here.db"_s, u"printed.db"_s, u"--json"_s}).exit,
                 3);
    }
    void anotherGrippersRecordingsAreJudgedWithTheAdjustment()
    {
        const Workplace work;
        GaussianNoise noise(5);
        // Gains of the other gripper; in numbers without units, as simulate writes them.
        const std::array<double, 3> here{1, 1, 1}, there{1.2, 0.85, 1.25};
        const auto squeeze = [&](const QString& file, double scale, const std::array<double, 3>& gain) {
            QStringList object;
            for (const auto& [value, factor] :
                 {std::pair(0.04, gain[0]), std::pair(0.14, gain[1]), std::pair(0.1, gain[2])})
                object << QString::number(value * scale * factor * std::exp(0.03 * noise()), 'g', 17);
            QCOMPARE(work.cli({u"simulate"_s, u"--object"_s, object.join(u','), u"--noise-sd"_s, u"0.05"_s,
                               u"--seed"_s, QString::number(int(1000 * noise.uniform())), u"-o"_s, file})
                         .exit,
                     0);
        };
        const auto enrollSome = [&](const QString& library, const QString& type, double scale, int count,
                                    const std::array<double, 3>& gain) {
            QStringList arguments{u"enroll"_s, u"--library"_s, library, u"--type"_s, type};
            for (int i = 0; i < count; ++i) {
                const QString file = library + type + QString::number(i) + u".csv"_s;
                squeeze(file, scale, gain);
                arguments << file;
            }
            QCOMPARE(work.cli(arguments).exit, 0);
        };
        for (const auto& [type, scale] : {std::pair(u"small"_s, 1.0), std::pair(u"large"_s, 1.8)}) {
            enrollSome(u"here.db"_s, type, scale, 6, here);
            enrollSome(u"there.db"_s, type, scale, 4, there);
        }
        squeeze(u"part.csv"_s, 1.8, there);
        const QStringList ask{u"classify"_s, u"--library"_s, u"here.db"_s, u"part.csv"_s, u"--json"_s};
        const auto verdict = [](const ProgramRun& run) {
            return run.json()[u"results"][0][u"verdict"].toString() + u' ' +
                   run.json()[u"results"][0][u"type"].toString();
        };
        QVERIFY2(verdict(work.cli(ask)) != u"type large"_s, "nothing to adjust");
        const ProgramRun adjusted = work.cli(ask + QStringList{u"--transfer"_s, u"there.db"_s});
        QVERIFY2(verdict(adjusted) == u"type large"_s, (adjusted.out + adjusted.err).constData());
        QCOMPARE(work.cli(ask + QStringList{u"--transfer"_s, u"none.db"_s}).exit, 5);

        // Once the library has the adjustment, the recording's own gripper finds it.
        const QString accepted = acceptAdjustment(work.path(u"here.db"_s), u"F-2"_s, there);
        QVERIFY(!accepted.isEmpty());
        const QJsonObject unnamed = work.cli(ask).json()[u"results"][0].toObject();
        QVERIFY2(!unnamed.contains(u"adjustment"), "the recording does not say by which gripper");
        QFile part(work.path(u"part.csv"_s));
        QVERIFY(part.open(QIODevice::ReadOnly));
        work.write(u"part.csv"_s, "# serial: F-2\n" + part.readAll());
        const ProgramRun stored = work.cli(ask);
        QVERIFY2(verdict(stored) == u"type large"_s, (stored.out + stored.err).constData());
        QCOMPARE(stored.json()[u"results"][0][u"adjustment"].toString(), accepted);
        QVERIFY(work.cli({u"classify"_s, u"--library"_s, u"here.db"_s, u"part.csv"_s})
                    .err.contains("as the library has it"));
        const QJsonObject stated =
            work.cli(ask + QStringList{u"--transfer"_s, u"there.db"_s}).json()[u"results"][0].toObject();
        QVERIFY2(!stated.contains(u"adjustment"), "what is stated goes before what is stored");
    }
    void aLibraryIsVerified()
    {
        const Workplace work;
        const QString file = work.path(u"lib.db"_s);
        QCOMPARE(work.cli({u"simulate"_s, u"--object"_s, u"2,3,40"_s, u"-o"_s, u"a.csv"_s}).exit, 0);
        QCOMPARE(work.cli({u"enroll"_s, u"--library"_s, file, u"--type"_s, u"Alphabet"_s, u"a.csv"_s}).exit,
                 0);
        const QStringList verify{u"library"_s, u"verify"_s, u"--library"_s, file, u"--json"_s};
        const ProgramRun whole = work.cli(verify);
        QCOMPARE(whole.exit, 0);
        QCOMPARE(whole.json().keys(), (QStringList{u"differences"_s, u"rows"_s, u"whole"_s, u"witness"_s}));
        QVERIFY(whole.json()[u"whole"_s].toBool() && whole.json()[u"rows"_s].toInt() > 15);
        QCOMPARE(whole.json()[u"witness"_s].toString(), u"matched"_s);
        QVERIFY(whole.json()[u"differences"_s].toArray().isEmpty());
        QCOMPARE(work.cli(verify + QStringList{u"--recompute"_s}).exit, 0);
        QVERIFY(work.cli(verify.first(4)).out.contains("as they were written"));
        // On a computer that does not know it.
        QVERIFY(QDir(work.path(u"gripscope/audit"_s)).removeRecursively());
        const ProgramRun alone = work.cli(verify);
        QCOMPARE(alone.exit, 7);
        QCOMPARE(alone.json()[u"witness"_s].toString(), u"absent"_s);
        QFile edited(file);
        QVERIFY(edited.open(QIODevice::ReadWrite));
        const QByteArray bytes = edited.readAll().replace("Alphabet", "Alphabot");
        QVERIFY(edited.seek(0) && edited.write(bytes) == bytes.size());
        edited.close();
        const ProgramRun changed = work.cli(verify);
        QCOMPARE(changed.exit, 6);
        QStringList tables;
        for (const QJsonValue difference : changed.json()[u"differences"_s].toArray()) {
            tables += difference[u"table"_s].toString();
            QVERIFY(!difference[u"row"_s].toString().isEmpty() &&
                    !difference[u"what"_s].toString().isEmpty());
        }
        QVERIFY(tables.contains(u"types"_s) && tables.contains(u"type_states"_s));
        QVERIFY(work.cli(verify.first(4)).out.contains("types"));
        QCOMPARE(work.cli({u"library"_s, u"verify"_s, u"--library"_s, work.path(u"none.db"_s)}).exit, 5);
        QCOMPARE(work.cli({u"library"_s}).exit, 2);
    }
    void aBackupIsMadeAndPutBackWithAReason()
    {
        const Workplace work;
        const QString file = work.path(u"lib.db"_s), copy = work.path(u"copy.db"_s);
        const auto enroll = [&](const QString& type) {
            return work.cli({u"enroll"_s, u"--library"_s, file, u"--type"_s, type, u"a.csv"_s}).exit;
        };
        QCOMPARE(work.cli({u"simulate"_s, u"--object"_s, u"2,3,40"_s, u"-o"_s, u"a.csv"_s}).exit, 0);
        QCOMPARE(enroll(u"First"_s), 0);
        const QStringList backup{u"library"_s, u"backup"_s, u"--library"_s, file, u"--json"_s, copy};
        const ProgramRun made = work.cli(backup);
        QCOMPARE(made.exit, 0);
        QVERIFY(made.json()[u"whole"_s].toBool());
        QCOMPARE(made.json()[u"types"_s].toInt(), 1);
        QVERIFY(work.cli(backup).exit != 0); // never over a file
        QCOMPARE(enroll(u"Second"_s), 0);
        const QStringList restore{u"library"_s, u"restore"_s, u"--library"_s, file, copy};
        QCOMPARE(work.cli(restore).exit, 2); // why?
        const ProgramRun restored = work.cli(restore + QStringList{u"--reason"_s, u"a trial"_s, u"--json"_s});
        QCOMPARE(restored.exit, 0);
        QVERIFY(QFile::exists(restored.json()[u"kept_as"_s].toString()));
        const ProgramRun verified = work.cli({u"library"_s, u"verify"_s, u"--library"_s, file, u"--json"_s});
        QCOMPARE(verified.exit, 0);
        QCOMPARE(verified.json()[u"witness"_s].toString(), u"matched"_s);
        QCOMPARE(verified.json()[u"restores"_s].toArray().at(0)[u"reason"_s].toString(), u"a trial"_s);
        const ProgramRun aside =
            work.cli({u"library"_s, u"verify"_s, u"--library"_s, restored.json()[u"kept_as"_s].toString()});
        QCOMPARE(aside.exit, 0);
    }
    void theLibraryOfAnotherStationIsMerged()
    {
        const Workplace work;
        const QString here = work.path(u"here.db"_s), there = work.path(u"there.db"_s);
        QCOMPARE(work.cli({u"simulate"_s, u"--object"_s, u"2,3,40"_s, u"-o"_s, u"a.csv"_s}).exit, 0);
        for (const QString& file : {here, there})
            QCOMPARE(work.cli({u"enroll"_s, u"--library"_s, file, u"--type"_s, u"Can"_s, u"a.csv"_s}).exit,
                     0);
        inspect(there, 1);
        const QStringList merge{u"library"_s, u"merge"_s, u"--library"_s, here, u"--json"_s};
        QCOMPARE(work.cli(merge).exit, 2);
        const ProgramRun merged = work.cli(merge + QStringList{there});
        QCOMPARE(merged.exit, 0);
        QCOMPARE(merged.json()[u"taken"_s][u"inspections"_s].toInt(), 40);
        const QJsonArray conflicts = merged.json()[u"conflicts"_s].toArray();
        QCOMPARE(conflicts.size(), 1);
        QCOMPARE(conflicts[0][u"kind"_s].toString(), u"same_name"_s);
        QCOMPARE(work.cli(merge + QStringList{there}).json()[u"rows"_s].toInt(), 0);
        const QStringList status{u"library"_s, u"status"_s, u"--library"_s, here, u"--json"_s};
        QCOMPARE(work.cli(status).json()[u"conflicts"_s].toArray().size(), 1);
        QCOMPARE(work.cli(status).json()[u"stations"_s][0][u"inspections"_s].toInt(), 40);
        QCOMPARE(work.cli(status + QStringList{u"--seen"_s}).json()[u"conflicts"_s].toArray().size(), 0);
        const ProgramRun verified = work.cli({u"library"_s, u"verify"_s, u"--library"_s, here, u"--json"_s});
        QCOMPARE(verified.exit, 0);
        QVERIFY(verified.json()[u"merged_rows"_s].toInt() > 3 * 40); // squeeze, estimate, inspection
        QCOMPARE(work.cli(merge + QStringList{work.path(u"none.db"_s)}).exit, 5);
        QCOMPARE(work.cli(merge + QStringList{work.path(u"a.csv"_s)}).exit, 5);
    }
    void inspectionsThatWereKeptAsideAreTakenBack()
    {
        const Workplace work;
        const QString file = work.path(u"lib.db"_s), other = work.path(u"other.db"_s);
        NewInspection inspection;
        inspection.id = newTimeOrderedId();
        inspection.grasp.forceUnit = u"N"_s;
        inspection.grasp.positionUnit = u"m"_s;
        inspection.verdict.kind = VerdictKind::Unknown;
        QString kept;
        {
            const auto library = Library::open(file), another = Library::open(other);
            QVERIFY(library && another);
            kept = InspectionSpill::keepAside(file, (*library)->birth().value(), inspection).value();
        }
        const auto takeBack = [&](const QString& into) {
            return work.cli({u"library"_s, u"take-back"_s, u"--library"_s, into, u"--json"_s, kept});
        };
        QVERIFY(takeBack(other).exit != 0); // it was made for the first
        QVERIFY(QFile::exists(kept));
        const ProgramRun taken = takeBack(file);
        QCOMPARE(taken.exit, 0);
        QCOMPARE(taken.json()[u"inspections"_s].toArray(), QJsonArray{1});
        QVERIFY(!QFile::exists(kept));
        QVERIFY(takeBack(file).exit != 0);
        QCOMPARE(Library::open(file).value()->inspectionCounts().value().total, 1);
    }
};

GRIPSCOPE_TEST(LibraryCommandTest)
#include "library_command_test.moc"
