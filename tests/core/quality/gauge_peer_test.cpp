// SPDX-License-Identifier: GPL-3.0-or-later
// Ten unbalanced tables by R's lme4 (tests/peers/gauge_reml.R). By hand too: test_core_quality GaugePeerTest.
#include "core/quality/gauge/cell_means.h"
#include "tests/core/quality/gauge_tables.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

std::vector<GaugeRow> peerRows(std::uint64_t table)
{
    // Operators, interaction and repeatability from small to large beside parts of deviation 2.
    const double size = 0.2 + 0.15 * double(table);
    return thinned(
        drawnCrossedRows(8, 4, 0, 3, {2, 1.5 * size, 0, size, 0, 0.3 + 0.1 * double(table)}, table),
        0.15 + 0.04 * double(table), table);
}

void writePeerTable(const QString& name, const std::vector<GaugeRow>& rows)
{
    QFile file(name);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("part,operator,value\n");
    for (const GaugeRow& row : rows)
        file.write(QByteArray::number(row.part) + ',' + QByteArray::number(row.operators) + ',' +
                   QByteArray::number(row.value, 'g', 17) + '\n');
}

} // namespace

class GaugePeerTest : public QObject {
    Q_OBJECT
private slots:
    void lme4FindsTheSameComponents()
    {
        const QString program = QStandardPaths::findExecutable(u"Rscript"_s);
        if (program.isEmpty())
            QSKIP("R is not installed (apt-get install r-cran-lme4)");
        QProcess asked;
        asked.start(program,
                    {u"-e"_s, u"quit(status = if (requireNamespace('lme4', quietly = TRUE)) 0 else 1)"_s});
        if (!asked.waitForFinished(60'000) || asked.exitCode() != 0)
            QSKIP("R has no lme4 (apt-get install r-cran-lme4)");
        const QTemporaryDir folder;
        QStringList arguments{QStringLiteral(GRIPSCOPE_SOURCE_DIR "/tests/peers/gauge_reml.R")};
        for (std::uint64_t table = 1; table <= 10; ++table) {
            arguments << folder.filePath(u"%1.csv"_s.arg(table));
            writePeerTable(arguments.last(), peerRows(table));
        }
        QProcess peer;
        peer.start(program, arguments);
        QVERIFY(peer.waitForFinished(120'000));
        QVERIFY2(peer.exitCode() == 0, peer.readAllStandardError().constData());
        const QList<QByteArray> lines = peer.readAllStandardOutput().trimmed().split('\n');
        QCOMPARE(lines.size(), 10);
        double worst = 0;
        for (std::uint64_t table = 1; table <= 10; ++table) {
            const std::vector<GaugeRow> rows = peerRows(table);
            const GaugeLayout layout = gaugeLayout(factorsOf(rows), GaugeDesign::Crossed).value();
            QVERIFY(!layout.balanced);
            const RestrictedLikelihoodResult found = restrictedLikelihood(layout, valuesOf(rows));
            const QList<QByteArray> fields = lines[qsizetype(table - 1)].simplified().split(' ');
            QCOMPARE(fields.size(), 5);
            for (Eigen::Index l = 0; l < 4; ++l) {
                const double theirs = fields[l + 1].toDouble();
                const double off = std::abs(found.variances[l] - theirs) / found.variances.sum();
                worst = std::max({worst, off, theirs > 1e-6 ? std::abs(found.variances[l] / theirs - 1) : 0});
                QVERIFY2(worst < 1e-4, qPrintable(u"table %1, component %2: %3 here, %4 by lme4"_s.arg(table)
                                                      .arg(l)
                                                      .arg(found.variances[l], 0, 'g', 10)
                                                      .arg(theirs, 0, 'g', 10)));
            }
        }
        qInfo("largest relative difference from lme4: %.2g", worst);
    }
};

GRIPSCOPE_TEST(GaugePeerTest)
#include "gauge_peer_test.moc"
