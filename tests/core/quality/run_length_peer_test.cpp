// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/run_length.h"
#include "tests/support/test_registry.h"

#include <QProcess>
#include <QStandardPaths>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class RunLengthPeerTest : public QObject {
    Q_OBJECT
private:
    static std::optional<RunLength> ours(const QStringList& cells)
    {
        const double first = cells[1].toDouble(), second = cells[2].toDouble(), shift = cells[3].toDouble();
        if (cells[0] == u"cusum"_s)
            return twoSidedCusumRunLength(first, second, shift);
        return ewmaRunLength(first, second, shift,
                             cells[4] == u"vacl"_s ? EwmaLimits::Exact : EwmaLimits::Fixed);
    }
private slots:
    void agreesWithThePackageSpc()
    {
        const QString program = QStandardPaths::findExecutable(u"Rscript"_s);
        if (program.isEmpty())
            QSKIP("R is not installed (apt-get install r-cran-spc)");
        QProcess process;
        process.start(program, {QStringLiteral(GRIPSCOPE_SOURCE_DIR "/tests/peers/run_lengths.R")});
        QVERIFY(process.waitForFinished(120'000));
        if (process.exitCode() != 0) {
            const QByteArray told = process.readAllStandardError();
            if (told.contains("spc"))
                QSKIP("R's package spc is not installed (apt-get install r-cran-spc)");
            QFAIL(told.constData());
        }
        const QStringList lines =
            QString::fromUtf8(process.readAllStandardOutput()).split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(lines.size(), 56);
        for (const QString& line : lines) {
            const QStringList cells = line.split(u',');
            QCOMPARE(cells.size(), 6);
            const std::optional<RunLength> length = ours(cells);
            QVERIFY2(length && std::abs(length->points / cells[5].toDouble() - 1) < 1e-4,
                     qPrintable(u"%1; here %2"_s.arg(line).arg(length ? length->points : 0, 0, 'g', 10)));
        }
    }
};

GRIPSCOPE_TEST(RunLengthPeerTest)
#include "run_length_peer_test.moc"
