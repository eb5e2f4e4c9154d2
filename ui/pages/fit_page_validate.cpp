// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_validate.h"

#include "core/identification/identification.h"
#include "core/identification/validation_records.h"
#include "core/signal/recording_csv.h"
#include "ui/widgets/date_text.h"
#include "ui/workbench.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

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
    const Expected<std::vector<TypeRecord>> types = library.types();
    if (!types)
        return tl::unexpected<Error>(types.error());
    std::vector<StoredChoices> all;
    for (const TypeRecord& type : *types) {
        const Expected<std::vector<GraspRecord>> grasps = library.grasps(type.id);
        if (!grasps)
            return tl::unexpected<Error>(grasps.error());
        StoredChoices choices{type.name, {}};
        int number = 0;
        for (const GraspRecord& grasp : *grasps) {
            ++number;
            if (!grasp.hasRecording || !grasp.accepted)
                continue;
            const QString when = timeText(grasp.recorded);
            choices.squeezes.push_back({grasp.id,
                                        ValidationChooser::tr("Squeeze %1, %2").arg(number).arg(when),
                                        ValidationChooser::tr("%1, squeeze %2").arg(type.name).arg(number)});
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
    : QObject(page), m_workbench(&workbench), m_menu(menu), m_page(page)
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
    m_workbench->ask<std::vector<StoredChoices>>(
        m_menu, storedChoices, [this](Expected<std::vector<StoredChoices>> all) {
            if (!all || all->empty() || m_menu->actions().size() != 1)
                return;
            m_menu->addSection(tr("Stored squeezes"));
            for (const StoredChoices& choices : *all) {
                QMenu* const type = m_menu->addMenu(choices.type);
                for (const StoredChoice& choice : choices.squeezes)
                    type->addAction(choice.text, this,
                                    [this, choice] { useStored(choice.graspId, choice.name); });
            }
        });
}

void ValidationChooser::chooseFile()
{
    auto* dialog = new QFileDialog(m_page, tr("Validate with a recording"), QString(),
                                   tr("Recordings (*.csv);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { useFile(file); });
    dialog->open();
}

void ValidationChooser::useFile(const QString& file)
{
    emit started();
    m_workbench->compute<Expected<Recording>>(
        this, [file] { return readRecordingCsv(file); },
        [this, name = QFileInfo(file).fileName(), generation = m_generation](Expected<Recording> other) {
            hold(std::move(other), name, generation);
        });
}

void ValidationChooser::useStored(const QString& graspId, const QString& name)
{
    emit started();
    m_workbench->ask<Recording>(
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
        m_workbench->report(other.error().describe());
        emit failed();
        return;
    }
    m_workbench->compute<Validation>(
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
