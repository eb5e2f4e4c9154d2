// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit/fit_page_validation.h"

#include "core/identification/identification.h"
#include "core/identification/validation/validation.h"
#include "ui/charts/channel_curve.h"
#include "ui/context/workbench.h"
#include "ui/format/date_text.h"
#include "ui/format/validation_words.h"
#include "ui/imports/recording_opener.h"
#include "ui/pages/fit/fit_page_table.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/plain_text.h"
#include "ui/windows/file_dialog.h"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

std::shared_ptr<std::vector<double>> sinceTheFirst(const std::vector<double>& times)
{
    auto result = std::make_shared<std::vector<double>>(times);
    for (double& time : *result)
        time -= times.front();
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
    auto* title = makeLabel(tr("On data it was not found from"), "strong");
    title->setWordWrap(true); // beside the button, in every language
    line->addWidget(title, 1);
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
                            : asSentence(validation.message.describe()));
    m_plot->setVisible(validation.available());
    fillFacts(m_facts, validationFacts(validation));
    if (!validation.available()) {
        m_plot->setCurves({});
        return;
    }
    double largest = 0;
    for (const double y : validation.position)
        largest = std::max(largest, std::abs(y));
    const ChannelScales scales(positionUnit, largest);
    const auto time = sinceTheFirst(validation.time_s);
    m_plot->setTitle(scales.shown.title(tr("Position")));
    m_plot->setCurves({channelCurve(tr("measured"), CurveRole::MeasuredPosition, time, validation.position,
                                    scales, tr("Measured position")),
                       channelCurve(tr("model from elsewhere"), CurveRole::Model, time, validation.simulated,
                                    scales, tr("Model"))});
    m_plot->setDuration(time->back());
    m_plot->fitVertical();
}

namespace {

/// A menu with more would not fit on a screen; these are the latest.
constexpr std::size_t mostOffered = 24;

struct StoredChoice {
    QString graspId, text, name;
};
struct StoredChoices {
    QString type;
    std::vector<StoredChoice> squeezes;
};

Expected<std::vector<StoredChoices>> storedChoices(Library& library)
{
    ASSIGN_OR_RETURN(const std::vector<TypeRecord> types, library.types());
    std::vector<StoredChoices> all;
    for (const TypeRecord& type : types) {
        ASSIGN_OR_RETURN(const std::vector<GraspRecord> grasps, library.grasps(type.id));
        StoredChoices choices{type.name, {}};
        int number = 0;
        for (const GraspRecord& grasp : grasps) {
            ++number;
            if (!grasp.hasRecording || !grasp.accepted)
                continue;
            const QString when = timeText(grasp.recorded);
            choices.squeezes.push_back(
                {grasp.id, ValidationChooser::tr("Squeeze %1, %2").arg(number).arg(when),
                 ValidationChooser::tr("%1, squeeze %2").arg(type.name, QString::number(number))});
        }
        std::reverse(choices.squeezes.begin(), choices.squeezes.end());
        choices.squeezes.resize(std::min(choices.squeezes.size(), mostOffered));
        if (!choices.squeezes.empty())
            all.push_back(std::move(choices));
    }
    return all;
}

} // namespace

ValidationChooser::ValidationChooser(Workbench& workbench, QMenu* menu, QWidget* page)
    : QObject(page), m_workbench(&workbench), m_menu(menu), m_page(page),
      m_opener(new RecordingOpener(workbench, page))
{
    connect(menu, &QMenu::aboutToShow, this, [this] { fillMenu(); });
}

void ValidationChooser::setSubject(const std::optional<FitSubject>& subject)
{
    ++m_generation;
    m_estimate.reset();
    if (!subject)
        return;
    m_recording = subject->recording;
    if (const Estimate* best = subject->identification.best())
        m_estimate = *best;
}

void ValidationChooser::fillMenu()
{
    m_menu->clear();
    QAction* file = m_menu->addAction(tr("A recording (CSV)…"), this, [this] { chooseFile(); });
    file->setEnabled(m_estimate.has_value());
    if (m_estimate)
        addStored();
}

void ValidationChooser::addStored()
{
    m_workbench->background().ask<std::vector<StoredChoices>>(
        m_menu, storedChoices, [this](Expected<std::vector<StoredChoices>> all) {
            if (!all || all->empty() || m_menu->actions().size() != 1)
                return;
            m_menu->addSection(tr("Stored squeezes"));
            for (const StoredChoices& choices : *all) {
                QMenu* const type = m_menu->addMenu(withoutKeys(choices.type));
                for (const StoredChoice& choice : choices.squeezes)
                    type->addAction(withoutKeys(choice.text), this,
                                    [this, choice] { useStored(choice.graspId, choice.name); });
            }
        });
}

void ValidationChooser::chooseFile()
{
    auto* dialog = new FileDialog(m_page, tr("Validate with a recording"), QString(),
                                  tr("Recordings (*.csv *.tsv *.txt);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { useFile(file); });
    dialog->open();
}

void ValidationChooser::useFile(const QString& file)
{
    emit started();
    const int generation = m_generation;
    m_opener->open(
        file,
        [this, name = QFileInfo(file).fileName(), generation](Recording other) {
            hold(std::move(other), name, generation);
        },
        [this, generation] {
            if (generation == m_generation)
                emit failed();
        });
}

void ValidationChooser::useStored(const QString& graspId, const QString& name)
{
    emit started();
    m_workbench->background().ask<Recording>(
        this, [graspId](Library& library) { return library.recording(graspId); },
        [this, name, generation = m_generation](Expected<Recording> other) {
            hold(std::move(other), name, generation);
        });
}

void ValidationChooser::hold(Expected<Recording> other, const QString& name, int generation)
{
    if (generation != m_generation || !m_estimate)
        return;
    if (!other) {
        m_workbench->messages().report(other.error().describe());
        emit failed();
        return;
    }
    m_workbench->background().compute<Validation>(
        this,
        [estimate = *m_estimate, recording = m_recording, other = std::move(*other), name] {
            return validateOnRecording(estimate, recording, other, name, {});
        },
        [this, generation](const Validation& validation) {
            if (generation == m_generation)
                emit validated(validation);
        });
}

} // namespace gripscope
