// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/live_estimate_card.h"

#include "ui/widgets/controls.h"
#include "ui/widgets/number_format.h"
#include "ui/widgets/parameter_text.h"

#include <QHBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

LiveEstimateCard::LiveEstimateCard(QWidget* parent) : QFrame(parent)
{
    setRole(this, "card");
    setObjectName("liveEstimate");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 16, 8);
    row->setSpacing(24);
    const auto add = [&](const QString& name) { return addCaptionedValue(row, name, 120, this); };
    m_values = {add(tr("Mass")), add(tr("Damping")), add(tr("Stiffness"))};
    m_samples = add(tr("Samples"));
    m_samples->setMinimumWidth(64);
    m_what = makeLabel({}, "second", this);
    m_what->setWordWrap(true);
    m_what->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_what, 1);
}

void LiveEstimateCard::show(const std::optional<RecursiveState>& state, bool following,
                            const QString& forceUnit, const QString& positionUnit)
{
    for (QLabel* value : m_values)
        value->setText(u"–"_s);
    m_samples->setText(state ? formatCount(static_cast<qint64>(state->samples)) : u"–"_s);
    if (!state) {
        m_what->setText(tr("m, b and k appear here while the gripper squeezes"));
        return;
    }
    m_what->setText(following ? tr("this squeeze so far") : tr("the last squeeze"));
    if (!state->parameters)
        return;
    std::optional<Eigen::Vector3d> errors;
    if (state->covariance)
        errors = state->covariance->diagonal().cwiseMax(0.0).cwiseSqrt();
    const ParameterTexts texts = parameterTexts(*state->parameters, errors, forceUnit, positionUnit);
    m_values[0]->setText(texts.m.text());
    m_values[1]->setText(texts.b.text());
    m_values[2]->setText(texts.k.text());
}

} // namespace gripscope
