// SPDX-License-Identifier: GPL-3.0-or-later
// The manual that is compiled in: whole, and about what the program says.
#include "core/identification/estimators/estimator_table.h"
#include "core/identification/identification.h"
#include "core/identification/recursive/recursive_estimator.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

QString page(const QString& name)
{
    QFile file(u":/manual/"_s + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// `name` as a cell of a table or within the text.
bool explains(const QString& text, const QString& name)
{
    return text.contains(u'`' + name + u'`');
}

} // namespace

class ManualTest : public QObject {
    Q_OBJECT
private slots:
    void everyPageIsThereAndIsLinkedFromTheFirst()
    {
        const QStringList pages = QDir(u":/manual"_s).entryList({u"*.md"_s});
        QVERIFY(pages.contains(u"index.md"_s));
        QVERIFY(pages.size() >= 6);
        for (const QString& name : pages) {
            QVERIFY2(page(name).startsWith(u"# "_s), qPrintable(name));
            QVERIFY2(name == u"index.md" || page(u"index.md"_s).contains(u'(' + name + u')'),
                     qPrintable(name));
        }
    }
    /// The same pages in German, with the same headings, tables, code, links and pictures.
    void theGermanPagesFollowTheEnglish()
    {
        static const QRegularExpression heading(u"^#+ "_s, QRegularExpression::MultilineOption);
        static const QRegularExpression code(u"```[^`]*```|`[^`]+`"_s);
        static const QRegularExpression link(u"\\]\\([^)]+\\)"_s);
        static const QRegularExpression row(u"^\\|"_s, QRegularExpression::MultilineOption);
        const auto all = [](const QRegularExpression& wanted, const QString& text) {
            QStringList found;
            for (const QRegularExpressionMatch& match : wanted.globalMatch(text))
                found << match.captured().simplified();
            return found;
        };
        const QStringList pages = QDir(u":/manual"_s).entryList({u"*.md"_s});
        QCOMPARE(QDir(u":/manual/de"_s).entryList({u"*.md"_s}), pages);
        for (const QString& name : pages) {
            const QString english = page(name), german = page(u"de/"_s + name);
            for (const QRegularExpression& wanted : {heading, row})
                QVERIFY2(all(wanted, german) == all(wanted, english),
                         qPrintable(name + u": "_s + wanted.pattern()));
            for (const QRegularExpression& wanted : {code, link}) {
                QStringList there = all(wanted, german), here = all(wanted, english);
                there.sort(); // within a sentence they may change places
                here.sort();
                for (qsizetype i = 0; i < std::max(there.size(), here.size()); ++i)
                    QVERIFY2(there.value(i) == here.value(i),
                             qPrintable(u"%1: %2, not %3"_s.arg(name, there.value(i), here.value(i))));
            }
        }
    }
    void everyScreenHasAPageWithItsPicture()
    {
        for (const char* screen :
             {"live", "inspect", "enroll", "types", "fit", "calibrate", "history", "quality"}) {
            const QString name = QString::fromLatin1(screen);
            const QString picture = u"pictures/%1.png"_s.arg(name);
            QVERIFY2(page(name + u".md"_s).contains(u'(' + picture + u')'), screen);
            QVERIFY2(QFile::exists(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/resources/manual/") + picture),
                     screen);
        }
    }
    void everyLinkLeadsSomewhere()
    {
        static const QRegularExpression link(u"(?<!!)\\[[^\\]]*\\]\\(([^)]+)\\)"_s); // not pictures
        for (const QString& name : QDir(u":/manual"_s).entryList({u"*.md"_s})) {
            auto found = link.globalMatch(page(name));
            while (found.hasNext()) {
                const QString target = found.next().captured(1);
                QVERIFY2(!page(target).isEmpty(), qPrintable(name + u": "_s + target));
            }
        }
    }
    void everyEstimatorIsExplained()
    {
        const QString text = page(u"identification.md"_s);
        for (const Estimator estimator : allEstimators())
            QVERIFY2(explains(text, toString(estimator)), qPrintable(toString(estimator)));
    }
    void everyStatusIsExplained()
    {
        const QString text = page(u"identification.md"_s);
        for (int i = 0; i <= static_cast<int>(EstimateStatus::NotApplicable); ++i)
            QVERIFY2(explains(text, toString(static_cast<EstimateStatus>(i))),
                     qPrintable(toString(static_cast<EstimateStatus>(i))));
        for (const RecursiveStatus status :
             {RecursiveStatus::Waiting, RecursiveStatus::Searching, RecursiveStatus::Following})
            QVERIFY2(explains(text, toString(status)), qPrintable(toString(status)));
    }
    void everyCheckIsExplained()
    {
        test::Synthetic synthetic;
        synthetic.fitPercent = 90;
        const QString text = page(u"validity.md"_s);
        const Identification identification = identify(synthetic.make());
        QVERIFY(identification.validity.checks.size() >= 10);
        for (const ValidityCheck& check : identification.validity.checks)
            QVERIFY2(explains(text, check.id), qPrintable(check.id));
        for (const ValidityVerdict verdict :
             {ValidityVerdict::Valid, ValidityVerdict::Suspect, ValidityVerdict::Invalid})
            QVERIFY(text.contains(u"**"_s + toString(verdict) + u"**"_s));
    }
    void everyLineOfTheBudgetIsExplained()
    {
        const QString text = page(u"uncertainty.md"_s);
        for (const QString& id :
             {u"position_noise"_s, u"noise"_s, u"force_noise"_s, u"quantization"_s, u"lag"_s, u"hold"_s,
              u"calibration"_s, u"frame_compliance"_s, u"baseline"_s, u"model_discrepancy"_s})
            QVERIFY2(explains(text, id), qPrintable(id));
    }
};

GRIPSCOPE_TEST(ManualTest)
#include "manual_test.moc"
