// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_validation.h"

#include "ui/charts/channel_scale.h"
#include "ui/charts/time_plot.h"
#include "ui/models/validation_words.h"
#include "ui/pages/fit_page_facts.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

std::shared_ptr<std::vector<double>> scaled(const std::vector<double>& values, double factor, double shift)
{
    auto result = std::make_shared<std::vector<double>>(values);
    for (double& value : *result)
        value = (value - shift) * factor;
    return result;
}

} // namespace

ValidationPanel::ValidationPanel(QWidget* parent)
    : QWidget(parent), m_sentence(makeLabel({})), m_plot(new TimePlot), m_facts(makeFactGrid()),
      m_choices(new QMenu(this))
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    auto* line = new QHBoxLayout;
    line->addWidget(makeLabel(tr("On data it was not found from"), "strong"), 1);
    auto* button = makeButton(tr("Validate with") + u" \u25BE"_s);
    button->setAccessibleName(tr("Validate with"));
    button->setToolTip(tr("Hold this estimate against another squeeze: its start and offset are fitted anew, "
                          "m, b and k are not"));
    button->setMenu(m_choices);
    line->addWidget(button);
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_plot->setMinimumHeight(148);
    m_plot->setHorizontalTitle(tr("Time (s)"));
    m_plot->setExportNames(tr("Validation"), u"validation"_s);
    column->addLayout(line);
    column->addWidget(m_sentence);
    column->addWidget(m_plot);
    column->addLayout(m_facts);
    setValidation({}, {});
}

void ValidationPanel::setValidation(const Validation& validation, const QString& positionUnit)
{
    m_sentence->setText(validation.message.isEmpty()
                            ? tr("This estimate was not held against other data yet.")
                            : asSentence(validation.message));
    m_plot->setVisible(validation.available());
    fillFacts(m_facts, validationFacts(validation));
    if (!validation.available()) {
        m_plot->setCurves({});
        return;
    }
    double largest = 0;
    for (const double y : validation.position)
        largest = std::max(largest, std::abs(y));
    const ChannelScale scale = channelScale(positionUnit, largest);
    const auto time = scaled(validation.time_s, 1, validation.time_s.front());
    m_plot->setTitle(scale.title(tr("Position")));
    m_plot->setCurves({{tr("measured"), CurveRole::MeasuredPosition, time,
                        scaled(validation.position, scale.factor, 0), scale.title(tr("Measured position"))},
                       {tr("model from elsewhere"), CurveRole::Model, time,
                        scaled(validation.simulated, scale.factor, 0), scale.title(tr("Model"))}});
    m_plot->setWhole({0, std::max(time->back(), 1e-9)});
    m_plot->showWhole();
    m_plot->fitVertical();
}

} // namespace gripscope
