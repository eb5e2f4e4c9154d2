// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/gauge/gauge_study.h"
#include "core/session/quality/study_result.h"
#include "tests/core/session/study_samples.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// Where two documents differ, numbers by more than rounding: the command line subtracts what a table's texts
/// say, the program what its numbers are.
QString firstDifference(const QJsonValue& one, const QJsonValue& other)
{
    if (one.isDouble() && other.isDouble()) {
        const double size = std::max({std::abs(one.toDouble()), std::abs(other.toDouble()), 1e-12});
        return std::abs(one.toDouble() - other.toDouble()) <= 1e-6 * size
                   ? QString()
                   : u"%1 and %2"_s.arg(one.toDouble(), 0, 'g', 17).arg(other.toDouble(), 0, 'g', 17);
    }
    if (one.isArray() && other.isArray() && one.toArray().size() == other.toArray().size()) {
        for (qsizetype i = 0; i < one.toArray().size(); ++i)
            if (const QString found = firstDifference(one.toArray()[i], other.toArray()[i]); !found.isEmpty())
                return u"[%1]%2"_s.arg(i).arg(found);
        return {};
    }
    if (one.isObject() && other.isObject() && one.toObject().keys() == other.toObject().keys()) {
        for (const QString& key : one.toObject().keys())
            if (const QString found = firstDifference(one[key], other[key]); !found.isEmpty())
                return u"/%1%2"_s.arg(key, found);
        return {};
    }
    return one == other ? QString() : u" differs: "_s + one.toString() + u" | "_s + other.toString();
}

} // namespace

/// A study that was made in the program, evaluated by the command line from its file.
class StudyCsvTest : public QObject {
    Q_OBJECT
private slots:
    void theFileOfAStudyGivesTheSameResult_data()
    {
        QTest::addColumn<bool>("whole");
        QTest::newRow("balanced") << true;
        QTest::newRow("squeezes left out") << false;
    }
    void theFileOfAStudyGivesTheSameResult()
    {
        QFETCH(bool, whole);
        KeptStudy study =
            madeStudy(crossedDesign(10, {u"Ada"_s, u"Bo, the second"_s, u"Cy"_s}, 3), {0.03, 0.01, 0.005});
        if (!whole) {
            study.measurements[5].undone = true;
            study.measurements[17].measured.outcome = u"skipped"_s;
        }
        const Workplace place;
        place.write(u"study.csv"_s, studyCsv(study));
        const ProgramRun run =
            place.cli({u"study"_s, u"gauge"_s, u"study.csv"_s, u"--part"_s, u"part"_s, u"--operator"_s,
                       u"operator"_s, u"--value"_s, u"m,b,k"_s, u"--uncertainty"_s, u"u_m,u_b,u_k"_s,
                       u"--design"_s, u"crossed"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        const auto result = gaugeResult(study);
        QVERIFY(result);
        const QJsonDocument here(gaugeJson(result->study));
        const QString difference =
            firstDifference(run.json(), QJsonDocument::fromJson(here.toJson()).object());
        QVERIFY2(difference.isEmpty(), qPrintable(difference));
    }
};
GRIPSCOPE_TEST(StudyCsvTest)
#include "study_csv_test.moc"
