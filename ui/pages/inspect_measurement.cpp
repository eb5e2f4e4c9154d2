// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect_measurement.h"

#include "core/signal/units.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/parameter_text.h"
#include "ui/widgets/type_map.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

InspectMeasurement::InspectMeasurement(QWidget* parent) : QFrame(parent)
{
    setRole(this, "card");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 8, 4);
    row->setSpacing(16);
    auto* numbers = new QVBoxLayout;
    numbers->setSpacing(0);
    numbers->addStretch(1);
    const auto add = [&](const QString& name) {
        numbers->addWidget(makeLabel(name, "caption", this));
        QLabel* value = makeLabel(u"–"_s, "number", this);
        value->setAccessibleName(name);
        value->setMinimumWidth(216);
        numbers->addWidget(value);
        numbers->addStretch(1);
        return value;
    };
    m_k = add(tr("stiffness k (95 %)"));
    m_b = add(tr("damping b (95 %)"));
    m_m = add(tr("moving mass m (95 %)"));
    m_map = new TypeMap(this);
    m_note = makeLabel(tr("This says nothing about the part: it is neither good nor bad. The squeeze is kept "
                          "under its number, but counts neither in the yield nor towards the batch."),
                       "", this);
    m_note->setObjectName("notJudgedNote");
    m_note->setWordWrap(true);
    m_note->hide();
    row->addLayout(numbers);
    row->addWidget(m_map, 1);
    row->addWidget(m_note, 1);
}

void InspectMeasurement::setTypes(const TypeModels& models)
{
    m_map->setTypes(models);
}

void InspectMeasurement::showResult(const std::optional<InspectSession::Result>& result)
{
    const bool invalid = result && result->outcome == InspectionOutcome::NotValid;
    m_map->setVisible(!invalid);
    m_note->setVisible(invalid);
    const std::optional<CorrectedParameters> object = result ? result->identification.object() : std::nullopt;
    if (object)
        return showObject(*result, *object);
    for (QLabel* label : {m_m, m_b, m_k})
        label->setText(u"–"_s);
    m_map->setPart(std::nullopt, std::nullopt);
}

void InspectMeasurement::showObject(const InspectSession::Result& result, const CorrectedParameters& object)
{
    const Recording& recording = result.recording;
    const ParameterTexts texts =
        parameterTexts(result.identification, recording.forceUnit, recording.positionUnit);
    const bool valid = result.outcome != InspectionOutcome::NotValid;
    // Numbers of a measurement that is not valid are not the part's: they step back.
    for (QLabel* label : {m_m, m_b, m_k})
        label->setEnabled(valid);
    m_m->setText(texts.m.text());
    m_b->setText(texts.b.text());
    m_k->setText(texts.k.text());
    const std::optional<double> si = siFactor(recording.forceUnit, recording.positionUnit);
    std::optional<MassDampingStiffness> part;
    std::optional<Eigen::Matrix3d> covariance;
    if (si && valid)
        part = MassDampingStiffness{object.parameters.m * *si, object.parameters.b * *si,
                                    object.parameters.k * *si};
    if (si && !object.covariance.isZero(0))
        covariance = *si * object.covariance * *si;
    m_map->setPart(part, covariance);
}

} // namespace gripscope
