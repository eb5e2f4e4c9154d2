// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/binomial_evidence.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/format/outcome_words.h"
#include "ui/format/yield_text.h"
#include "ui/pages/inspect/inspect_batch.h"
#include "ui/pages/inspect/inspect_parts.h"
#include "ui/settings/values/settings.h"
#include "ui/settings/values/shift_start.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/fitted_label.h"
#include "ui/widgets/inspection_widgets.h"
#include "ui/windows/question.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {
constexpr int linesShown = 100;
constexpr int narrowest = 304, widest = 520;
constexpr int smallestCount = 48, largestCount = 96; ///< pixels
constexpr double countOfHeight = 0.085;              ///< no more, so that a wide, low window has its list
} // namespace

InspectSummary::InspectSummary(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench)
{
    setObjectName("inspectSummary");
    setMinimumWidth(narrowest);
    setMaximumWidth(widest);
    QFrame* card = makeCard(this);
    m_batch = new InspectBatch(workbench, card);
    auto* head = new QVBoxLayout;
    buildHead(head, card);
    m_list = new InspectionList(card);
    m_list->setObjectName("inspectionList");
    m_list->setMinimumHeight(metrics::touchTarget);
    m_empty = makeLabel(tr("No part was inspected yet. Each squeeze is listed here with its verdict."),
                        "second", card);
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignTop);
    m_empty->setContentsMargins(16, 8, 16, 8);
    m_strip = new YieldStrip(card);
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
    takeShift();
    refreshCounts();
    reload();
}

void InspectSummary::buildHead(QBoxLayout* column, QWidget* card)
{
    m_period = makeLabel({}, "strong", card);
    m_period->setObjectName("periodLabel");
    m_period->setWordWrap(true); // beside the button, in every language
    m_newShift = makeButton(tr("New shift…"), {}, "quiet", card);
    m_newShift->setObjectName("newShiftButton");
    m_newShift->setToolTip(tr("Counts from now on. What was inspected before is kept in the history."));
    m_newShift->setFocusPolicy(Qt::TabFocus); // a click must not take Space from the squeeze
    connect(m_newShift, &QPushButton::clicked, this, &InspectSummary::askForShift);
    m_good = new FittedLabel(smallestCount, card);
    m_good->setObjectName("goodCount");
    m_share = makeLabel({}, "strong", card);
    m_share->setObjectName("yieldLabel");
    m_share->setWordWrap(true);
    m_split = makeLabel({}, "caption", card);
    m_split->setObjectName("splitLabel");
    m_split->setWordWrap(true);
    m_types = new ElidedLabel({}, card);
    m_types->setObjectName("typesLabel");
    setRole(m_types, "caption");
    m_shown = makeLabel({}, "caption", card);
    m_shown->setObjectName("shownLabel");
    m_shown->setWordWrap(true);
    column->setContentsMargins(16, 8, 16, 8);
    column->setSpacing(2);
    auto* row = new QHBoxLayout;
    row->addWidget(m_period, 1);
    row->addWidget(m_newShift);
    column->addLayout(row);
    column->addWidget(m_good);
    column->addWidget(m_share);
    column->addWidget(m_split);
    column->addWidget(m_types);
    column->addSpacing(4);
    column->addWidget(m_shown);
}

/// Further away stands who has the larger window.
void InspectSummary::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const double share = double(width() - narrowest) / (widest - narrowest);
    const double byWidth = smallestCount + share * (largestCount - smallestCount);
    const int count =
        std::clamp(int(std::min(byWidth, countOfHeight * height())), smallestCount, largestCount);
    m_good->setFixedHeight(count);
    m_batch->setCountHeight(count);
}

void InspectSummary::takeShift()
{
    Workbench& bench = *m_workbench;
    m_shift = ShiftStart::afterIn(bench.library().file(), bench.settings().get(setting::shiftStart));
    bench.inspection().setShiftStart(m_shift);
}

void InspectSummary::beginShift()
{
    const InspectionCounts now = m_workbench->inspection().counts();
    // Numbers have no holes: so many there are, and so far they go.
    m_workbench->settings().set(setting::shiftStart,
                                ShiftStart{m_workbench->library().file(), now.total + now.voided}.text());
    takeShift();
}

void InspectSummary::askForShift()
{
    auto* question =
        new Question(tr("Begin a new shift?"),
                     tr("Its counts begin at 0. What was inspected is kept, and a batch goes on."),
                     tr("Begin it"), tr("Leave it"), this);
    question->setObjectName("newShiftDialog");
    question->yes()->setObjectName("newShiftAccept");
    connect(question, &QDialog::accepted, this, [this] {
        beginShift();
        refreshCounts();
    });
    question->open();
}

void InspectSummary::refreshCounts()
{
    const InspectSession& session = m_workbench->inspection();
    const InspectionCounts all = session.counts();
    if (session.state() != InspectSession::State::Loading && all.total + all.voided < m_shift)
        beginShift(); // an older library is in its place since, such as a backup
    const InspectionCounts& counts = session.shiftCounts();
    const bool shift =
        ShiftStart::isOf(m_workbench->library().file(), m_workbench->settings().get(setting::shiftStart));
    const QString good = tr("%1 of %2").arg(formatCount(counts.asExpected), formatCount(counts.judged()));
    const QString period = shift ? tr("This shift") : tr("All so far");
    const bool batch = session.batch().has_value(); // then its count is read from afar
    m_period->setText(batch ? u"%1: %2"_s.arg(period, good) : period);
    m_good->setText(good);
    m_good->setAccessibleName(yieldCounted(counts));
    m_good->setVisible(!batch);
    const QString yield = yieldText(counts);
    m_share->setVisible(!yield.isEmpty() && !batch);
    m_share->setText(yield);
    m_share->setToolTip(yieldExplained(counts));
    QStringList parts{tr("%1 inspected").arg(formatCount(counts.total))};
    const auto add = [&parts](qint64 count, InspectionOutcome outcome) {
        if (count > 0)
            parts << u"%1 %2"_s.arg(formatCount(count), outcomeWord(outcome));
    };
    add(counts.otherType, InspectionOutcome::OtherType);
    if (counts.doesNotConform > 0)
        parts << tr("%1 not conforming").arg(formatCount(counts.doesNotConform));
    add(counts.unknown, InspectionOutcome::Unknown);
    add(counts.inconclusive, InspectionOutcome::Inconclusive);
    add(counts.invalid, InspectionOutcome::NotValid);
    if (counts.voided > 0)
        parts << tr("%1 voided").arg(formatCount(counts.voided));
    m_split->setText(parts.join(u" · "_s));
    refreshTypes(counts);
    refreshEvidence(session.counts());
}

void InspectSummary::refreshTypes(const InspectionCounts& shift)
{
    QStringList types;
    const auto add = [&](const QString& type, const ExpectedCounts& known) {
        if (known.judged() > 0)
            types
                << tr("%1: %2 of %3").arg(type, formatCount(known.asExpected()), formatCount(known.judged()));
    };
    if (!m_expected.isEmpty()) // the one that is worked on is never cut
        add(m_expected, shift.expected.value(m_expected));
    for (auto one = shift.expected.begin(); one != shift.expected.end(); ++one)
        if (one.key() != m_expected)
            add(one.key(), one.value());
    m_types->setVisible(!types.isEmpty() && !m_workbench->inspection().batch());
    m_types->setParts(types, u"  ·  "_s);
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
                    m_workbench->navigator().showInFit({title, r, found, u"inspect"_s});
                });
        });
}

} // namespace gripscope
