// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/binomial_evidence.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/format/outcome_words.h"
#include "ui/format/yield_text.h"
#include "ui/pages/inspect/inspect_batch.h"
#include "ui/pages/inspect/inspect_parts.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/inspection_widgets.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {
constexpr int linesShown = 100;
}

InspectSummary::InspectSummary(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench)
{
    setFixedWidth(304);
    QFrame* card = makeCard(this);
    m_total = makeLabel({}, "big-number", card);
    m_batch = new InspectBatch(workbench, card);
    m_share = makeLabel({}, "strong", card);
    m_share->setObjectName("yieldLabel");
    m_split = makeLabel({}, "caption", card);
    m_split->setWordWrap(true);
    m_shown = makeLabel({}, "caption", card);
    m_shown->setObjectName("shownLabel");
    m_shown->setWordWrap(true);
    m_list = new InspectionList(card);
    m_list->setObjectName("inspectionList");
    m_empty = makeLabel(tr("No part was inspected yet. Each squeeze is listed here with its verdict."),
                        "second", card);
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignTop);
    m_empty->setContentsMargins(16, 8, 16, 8);
    m_strip = new YieldStrip(card);
    auto* head = new QVBoxLayout;
    head->setContentsMargins(16, 12, 16, 8);
    head->setSpacing(2);
    head->addWidget(m_total);
    head->addWidget(m_share);
    head->addWidget(m_split);
    head->addSpacing(6);
    head->addWidget(m_shown);
    auto* foot = new QVBoxLayout;
    foot->setContentsMargins(16, 8, 16, 12);
    foot->setSpacing(4);
    foot->addWidget(makeLabel(tr("The last 20, the newest framed"), "caption", card));
    foot->addWidget(m_strip);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 2, 0);
    column->addWidget(m_batch);
    column->addWidget(makeRule(card));
    column->addLayout(head);
    column->addWidget(makeRule(card));
    column->addWidget(m_list, 1);
    column->addWidget(m_empty, 1);
    column->addWidget(makeRule(card));
    column->addLayout(foot);
    auto* outer = new QVBoxLayout(this);
    setSpacing(outer, 0, 0);
    outer->addWidget(card);

    connect(m_list, &InspectionList::opened, this, &InspectSummary::open);
    connect(m_strip, &YieldStrip::opened, this, &InspectSummary::open);
    connect(&workbench, &Workbench::inspectionChanged, this, &InspectSummary::refreshCounts);
    connect(&workbench, &Workbench::libraryChanged, this, &InspectSummary::reload);
    connect(&workbench, &Workbench::ratesChanged, this, &InspectSummary::refreshCounts);
    refreshCounts();
    reload();
}

void InspectSummary::refreshCounts()
{
    const InspectionCounts counts = m_workbench->inspection().counts();
    m_total->setText(tr("%1 inspected").arg(formatCount(counts.total)));
    const QString yield = yieldText(counts);
    m_share->setVisible(!yield.isEmpty());
    m_share->setText(yield);
    m_share->setToolTip(yieldExplained(counts));
    QStringList parts;
    const auto add = [&parts](qint64 count, InspectionOutcome outcome) {
        if (count > 0)
            parts << u"%1 %2"_s.arg(formatCount(count), outcomeWord(outcome));
    };
    add(counts.otherType, InspectionOutcome::OtherType);
    add(counts.unknown, InspectionOutcome::Unknown);
    add(counts.inconclusive, InspectionOutcome::Inconclusive);
    add(counts.invalid, InspectionOutcome::NotValid);
    m_split->setText(parts.join(u" · "_s));
    m_split->setVisible(!parts.isEmpty());
    refreshEvidence(counts);
}

void InspectSummary::setExpected(const QString& type)
{
    if (m_expected == type)
        return;
    m_expected = type;
    m_batch->setExpected(type);
    refreshCounts();
}

void InspectSummary::refreshEvidence(const InspectionCounts& counts)
{
    ExpectedCounts known = counts.expected.value(m_expected);
    if (m_expected.isEmpty())
        for (const ExpectedCounts& one : counts.expected) {
            known.squeezes += one.squeezes;
            known.otherType += one.otherType;
            known.unknown += one.unknown;
        }
    m_shown->setVisible(known.squeezes > 0);
    if (known.squeezes == 0)
        return;
    const auto proves = [&known](const QString& what, qint64 wrong) {
        const BinomialEvidence evidence = binomialEvidence(wrong, known.squeezes);
        return tr("%1: %2 of %3, so at most %4")
            .arg(what, formatCount(wrong), formatCount(known.squeezes),
                 formatPercent(100 * evidence.highest));
    };
    const QStringList lines{m_expected.isEmpty() ? tr("If each part was of the type expected:")
                                                 : tr("If each part was of type %1:").arg(m_expected),
                            proves(tr("other type"), known.otherType), proves(tr("unknown"), known.unknown)};
    m_shown->setText(lines.join(u'\n'));
    m_shown->setToolTip(tr("Exact bounds with 95 % confidence. Wrong type: %1")
                            .arg(inWords(binomialEvidence(known.otherType, known.squeezes),
                                         m_workbench->rates().rates.wrongType)
                                     .describe()));
}

void InspectSummary::reload()
{
    m_workbench->background().ask<std::vector<InspectionRecord>>(
        this,
        [](Library& library) {
            HistoryFilter filter;
            filter.limit = linesShown;
            return library.inspections(filter);
        },
        [this](const Expected<std::vector<InspectionRecord>>& found) {
            if (!found)
                return; // the sessions report a library that cannot be read
            std::vector<InspectionLine> lines;
            std::deque<InspectionLine> oldestFirst;
            for (const InspectionRecord& record : *found) {
                lines.push_back(inspectionLine(record));
                oldestFirst.push_front(lines.back());
            }
            m_list->setVisible(!lines.empty());
            m_empty->setVisible(lines.empty());
            m_list->setLines(std::move(lines));
            m_strip->setLines(std::move(oldestFirst));
            refreshCounts();
        });
}

void InspectSummary::open(const QString& graspId, qint64 number)
{
    const QString title = tr("Inspection %1").arg(number);
    m_workbench->background().ask<Recording>(
        this, [graspId](Library& library) { return library.recording(graspId); },
        [this, title](const Expected<Recording>& recording) {
            if (!recording) {
                m_workbench->messages().report(recording.error().describe());
                return;
            }
            m_workbench->background().compute<Identification>(
                this, [r = *recording] { return identify(r); },
                [this, title, r = *recording](const Identification& found) {
                    m_workbench->navigator().showInFit({title, r, found});
                });
        });
}

} // namespace gripscope
