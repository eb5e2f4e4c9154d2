// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/number_format.h"
#include "ui/pages/enroll/enroll_review_panel.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

enum CheckColumn { Name, Itself, Another, Unknown, Undecided, AtMost, ColumnCount };

/// "2 (B, C)": how many squeezes of a type were called others, and which.
QString anotherType(const HeldOutConfusion& confusion, int row)
{
    int count = 0;
    QStringList names;
    for (int column = 0; column < confusion.types.size(); ++column) {
        if (column == row || confusion.counts(row, column) == 0)
            continue;
        count += confusion.counts(row, column);
        names += confusion.types[column];
    }
    return count == 0 ? u"0"_s : u"%1 (%2)"_s.arg(count).arg(names.join(u", "_s));
}

} // namespace

EnrollCheck::EnrollCheck(QWidget* parent) : QWidget(parent), m_table(new QTableWidget(0, ColumnCount, this))
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 8);
    m_table->setObjectName("heldOutTable");
    m_table->setAccessibleName(tr("What held-out squeezes are called"));
    m_table->setHorizontalHeaderLabels({tr("Squeezes\nof"), tr("as\nitself"), tr("another\ntype"),
                                        tr("un-\nknown"), tr("incon-\nclusive"),
                                        tr("wrong at\nmost (95 %)")});
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(32);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
    m_words = makeLabel({}, "caption", this);
    m_words->setObjectName("heldOutWords");
    m_words->setWordWrap(true);
    column->addWidget(m_table, 1);
    column->addWidget(m_words);
    clear();
}

void EnrollCheck::clear()
{
    m_table->setRowCount(0);
    m_words->setText(tr("Each squeeze is being judged by all the others…"));
}

void EnrollCheck::fillRow(const HeldOutConfusion& confusion, int row, bool strong)
{
    const int types = static_cast<int>(confusion.types.size());
    const BinomialEvidence& wrong = confusion.wrongTypeOf[static_cast<std::size_t>(row)];
    const QString texts[ColumnCount] = {confusion.types[row],
                                        QString::number(confusion.counts(row, row)),
                                        anotherType(confusion, row),
                                        QString::number(confusion.counts(row, types)),
                                        QString::number(confusion.counts(row, types + 1)),
                                        wrong.trials > 0 ? formatPercent(100 * wrong.highest) : u"–"_s};
    for (int column = 0; column < ColumnCount; ++column) {
        auto* item = new QTableWidgetItem(texts[column]);
        item->setTextAlignment(Qt::AlignVCenter | (column == Name ? Qt::AlignLeft : Qt::AlignRight));
        item->setFont(Theme::font(metrics::fontBase, strong));
        item->setToolTip(texts[column]); // a long name ends in dots
        m_table->setItem(row, column, item);
    }
}

void EnrollCheck::show(const HeldOutConfusion& confusion, const QString& type, const VerdictOptions& rates)
{
    m_table->setRowCount(static_cast<int>(confusion.types.size()));
    for (int row = 0; row < m_table->rowCount(); ++row)
        fillRow(confusion, row, confusion.types[row] == type);
    if (confusion.parts == 0) {
        m_words->setText(tr("A type needs two squeezes, of two parts, to be checked."));
        return;
    }
    m_words->setText(tr("Each squeeze judged by all the others. Another type: %1 Unknown: %2")
                         .arg(inWords(confusion.wrongType, rates.wrongType).describe(),
                              inWords(confusion.unknown, rates.falseReject).describe()));
    const int own = static_cast<int>(confusion.types.indexOf(type));
    if (own >= 0)
        m_table->scrollToItem(m_table->item(own, 0));
}

QStringList reviewSentences(const EnrollmentReview& review)
{
    QStringList sentences;
    for (const auto& [row, outlier] : review.advice.outliers)
        sentences += EnrollCheck::tr("Squeeze %1 does not go with the others. %2")
                         .arg(row + 1)
                         .arg(outlier.reason.describe());
    if (review.overlap)
        sentences += inWords(*review.overlap).describe();
    else if (review.advice.progress.gate)
        sentences += EnrollCheck::tr("No other type overlaps it.");
    if (review.partDeviation && review.regripDeviation)
        sentences +=
            EnrollCheck::tr(
                "Stiffness differs by %1 from part to part and by %2 from grip to grip (1 sd, all types).")
                .arg(formatPercent(100 * *review.partDeviation),
                     formatPercent(100 * *review.regripDeviation));
    return sentences;
}

} // namespace gripscope
