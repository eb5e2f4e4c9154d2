// SPDX-License-Identifier: GPL-3.0-or-later
// The manual's walkthrough of writing a profile, followed word by word.
#include "core/signal/recording/units.h"
#include "devices/address/virtual_object.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QRegularExpression>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// A fenced block of the page: what stands behind the fence, and the lines up to the next one.
struct Block {
    QString kind; ///< "sh", "json my_gripper.json", or empty for what a program prints
    QString text;
};

std::vector<Block> blocksOfThePage()
{
    QFile file(u":/manual/profiles.md"_s);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString page = QString::fromUtf8(file.readAll());
    static const QRegularExpression fence(u"^```(.*)\\n([\\s\\S]*?)^```$"_s,
                                          QRegularExpression::MultilineOption);
    std::vector<Block> blocks;
    auto found = fence.globalMatch(page);
    while (found.hasNext()) {
        const QRegularExpressionMatch match = found.next();
        blocks.push_back({match.captured(1), match.captured(2)});
    }
    return blocks;
}

/// A command line as a shell takes it apart, without the program's name.
QStringList argumentsOf(const QString& line)
{
    QStringList words = QProcess::splitCommand(line);
    Q_ASSERT(words.value(0) == u"gripscope-cli");
    return words.mid(1);
}

} // namespace

class ProfileWalkthroughTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;
    QMap<QString, ProgramRun> m_runs; ///< by command line
    QStringList m_lines;              ///< in order

    [[nodiscard]] QString lineWith(const QString& words) const
    {
        const QStringList found = m_lines.filter(words);
        return found.isEmpty() ? QString() : found.first();
    }

private slots:
    void initTestCase() { qunsetenv("GRIPSCOPE_PROFILES"); }
    void everyStepWorksAsItIsWritten()
    {
        int files = 0;
        for (const Block& block : blocksOfThePage()) {
            if (block.kind.startsWith(u"json ")) {
                m_work.write(block.kind.mid(5), block.text.toUtf8());
                ++files;
            }
            if (block.kind != u"sh")
                continue;
            for (const QString& line : block.text.split(u'\n', Qt::SkipEmptyParts)) {
                m_runs[line] = m_work.cli(argumentsOf(line));
                m_lines << line;
                QVERIFY2(m_runs[line].exit == 0,
                         qPrintable(line + u'\n' + QString::fromUtf8(m_runs[line].err)));
            }
        }
        QCOMPARE(files, 1);
        QVERIFY(m_lines.size() >= 8);
    }
    void theBytesMoveAsThePageShows()
    {
        const QString printed = QString::fromUtf8(m_runs[lineWith(u"profile watch"_s)].out);
        QString shown;
        for (const Block& block : blocksOfThePage())
            if (block.kind.isEmpty() && shown.isEmpty())
                shown = block.text;
        static const QRegularExpression row(u"^ +(\\d+) +[0-9A-F]{2} +[0-9A-F]{2} +[0-9A-F]{2} +(-|\\d+)"_s,
                                            QRegularExpression::MultilineOption);
        const auto rows = [](const QString& table) {
            QStringList all;
            auto match = row.globalMatch(table);
            while (match.hasNext()) {
                const QRegularExpressionMatch one = match.next();
                all << one.captured(1) + (one.captured(2) == u"-" ? u" rests"_s : u" moves"_s);
            }
            return all.join(u'\n');
        };
        QCOMPARE(rows(shown).count(u'\n'), 15);
        QCOMPARE(rows(printed), rows(shown));
    }
    void nothingIsLostByTheProfileThatWasWritten()
    {
        const QString line = lineWith(u"--profile my_gripper.json"_s);
        const QByteArray out = m_runs[line].out;
        QVERIFY2(out.contains(" 0 lost, 0 reports came twice, 0 were not as the profile says"), out);
        QVERIFY(out.contains("counter") || out.contains("sequence"));
    }
    void theStiffnessOfTheCanIsWithinItsInterval()
    {
        const QString line = lineWith(u"identify"_s);
        QVERIFY2(m_runs[line].out.contains("measurement: valid"), m_runs[line].out);
        const QJsonObject found = m_work.cli(argumentsOf(line) + QStringList(u"--json"_s)).json();
        const QJsonObject units = found[u"recording"_s][u"units"_s].toObject();
        const double si = siFactor(units[u"force"_s].toString(), units[u"position"_s].toString()).value();
        for (const QJsonValue estimate : found[u"estimates"_s].toArray()) {
            if (estimate[u"estimator"_s] != found[u"recommended"_s])
                continue;
            const double k = si * estimate[u"parameters"_s][u"k"_s].toDouble();
            const double error = si * estimate[u"standard_errors"_s][u"k"_s].toDouble();
            const double truth = VirtualObject::fromText(u"A"_s)->draw(1, 0).k;
            QVERIFY2(std::abs(k - truth) < 1.96 * error, // 95 %; the same recording on every run
                     qPrintable(u"%1 ± %2, true %3"_s.arg(k).arg(error).arg(truth)));
            QVERIFY(error < 0.01 * truth); // and it says something
            return;
        }
        QFAIL("no recommended estimate");
    }
};

GRIPSCOPE_TEST(ProfileWalkthroughTest)
#include "profile_walkthrough_test.moc"
