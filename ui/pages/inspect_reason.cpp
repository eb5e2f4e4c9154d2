// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect_reason.h"

#include "core/words.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/number_format.h"
#include "ui/widgets/outcome_view.h"

#include <QVBoxLayout>

#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

InspectReason::InspectReason(QWidget* parent)
    : QWidget(parent), m_facts(new ElidedLabel({}, this)), m_rates(new ElidedLabel({}, this)),
      m_reason(makeLabel({}, "", this))
{
    setRole(m_facts, "strong");
    setRole(m_rates, "caption");
    m_rates->setObjectName("ratesLabel");
    m_reason->setObjectName("reasonLabel");
    m_reason->setWordWrap(true);
    m_reason->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_facts->hide();
    m_reason->hide();
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 2);
    column->addWidget(m_facts);
    column->addWidget(m_reason);
    column->addWidget(m_rates);
}

namespace {

QStringList factsOf(const InspectSession::Result& result)
{
    const Verdict& verdict = result.verdict;
    QStringList facts;
    const QString of = verdict.type.isEmpty() ? verdict.nearest : verdict.type;
    if (result.outcome != InspectionOutcome::NotValid && !of.isEmpty()) {
        if (verdict.posterior.contains(of) && result.outcome != InspectionOutcome::Unknown)
            facts << InspectReason::tr("posterior of %1: %2")
                         .arg(of, formatProbability(verdict.posterior.value(of)));
        if (verdict.distance && verdict.gate)
            facts << InspectReason::tr("%1 sd from %2 (gate %3 sd)")
                         .arg(Words::number(std::sqrt(*verdict.distance), 'f', 1), of,
                              Words::number(std::sqrt(*verdict.gate), 'f', 1));
    }
    if (result.earlyEnd)
        facts << InspectReason::tr("decided after %1 s")
                     .arg(Words::number(static_cast<double>(result.earlyEnd->samples) *
                                            result.recording.sampleTime_s,
                                        'g', 2));
    return facts;
}

} // namespace

void InspectReason::showResult(const InspectSession::Result* result)
{
    if (!result) {
        // Their room stays from the first verdict on, so that nothing jumps while the next squeeze runs.
        m_facts->setFullText(u" "_s);
        m_reason->clear();
        return;
    }
    // What to do about a bad measurement may take two lines and has no facts beside it.
    m_facts->setVisible(result->outcome != InspectionOutcome::NotValid);
    m_reason->show();
    const QStringList facts = factsOf(*result);
    m_facts->setParts(facts.isEmpty() ? QStringList{u" "_s} : facts, u"  ·  "_s);
    m_reason->setText(verdictWords(*result).reason);
    m_reason->setToolTip(result->verdict.reasons.join(u' '));
}

void InspectReason::showRates(const VerdictOptions& rates)
{
    m_rates->setFullText(tr("Held to: false-reject %1 (%2), wrong-type %3, stranger-accept %4")
                             .arg(formatRate(rates.falseReject),
                                  rates.confidence
                                      ? tr("with %1 confidence").arg(formatRate(*rates.confidence))
                                      : tr("on average"),
                                  formatRate(rates.wrongType), formatRate(rates.strangerAccept)));
}

} // namespace gripscope
