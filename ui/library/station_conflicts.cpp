// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/library/station_conflicts.h"

#include "core/library/library.h"
#include "ui/context/workbench.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using FoundConflicts = std::vector<PlantConflict>;

/// A window has room for so many; all are in the audit trail.
constexpr std::size_t mostConflictsShown = 5;

QStringList conflictWords(const FoundConflicts& conflicts)
{
    QStringList words;
    for (const PlantConflict& conflict : conflicts)
        if (words.size() < qsizetype(mostConflictsShown))
            words += inWords(conflict);
    return words;
}

void askForConflicts(Workbench& bench, QObject* context, std::function<void(FoundConflicts)> then)
{
    bench.background().ask<FoundConflicts>(
        context, [](Library& library) { return library.conflicts(); },
        [then = std::move(then)](Expected<FoundConflicts> found) {
            if (found) // what cannot be read is told by whatever needs it
                then(std::move(*found));
        });
}

} // namespace

void tellStationConflicts(Workbench& bench, QObject* window)
{
    askForConflicts(bench, window, [&bench](const FoundConflicts& conflicts) {
        if (!conflicts.empty())
            bench.messages().report(
                StationConflicts::tr(
                    "Stations decided apart, which a supervisor is to look at (Library…): %1")
                    .arg(conflictWords(conflicts).first()));
    });
}

StationConflicts::StationConflicts(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_text(makeLabel({}, "", this)),
      m_seen(makeButton(tr("I have seen it"), {}, "", this))
{
    setObjectName("stationConflicts");
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 8);
    column->addWidget(makeLabel(tr("Stations decided apart"), "caption", this));
    m_text->setObjectName("stationConflictsText");
    m_text->setWordWrap(true);
    column->addWidget(m_text);
    m_seen->setObjectName("stationConflictsSeen");
    m_seen->setAutoDefault(false);
    column->addWidget(m_seen, 0, Qt::AlignLeft);
    connect(m_seen, &QPushButton::clicked, this, &StationConflicts::markSeen);
    hide();
    reload();
}

void StationConflicts::reload()
{
    askForConflicts(*m_workbench, this, [this](FoundConflicts conflicts) { put(std::move(conflicts)); });
}

void StationConflicts::put(std::vector<PlantConflict> conflicts)
{
    m_conflicts = std::move(conflicts);
    QStringList words = conflictWords(m_conflicts);
    if (m_conflicts.size() > mostConflictsShown)
        words += tr("And %n more, in the audit trail.", nullptr,
                    static_cast<int>(m_conflicts.size() - mostConflictsShown));
    m_text->setText(words.join(u'\n'));
    setVisible(!m_conflicts.empty());
}

void StationConflicts::markSeen()
{
    authorize(*m_workbench, this, Permission::ChangeTypes, [this] {
        m_workbench->background().ask<void>(
            this,
            [conflicts = m_conflicts, person = m_workbench->operatorName()](Library& library) {
                return library.noteConflictsSeen(conflicts, {person, {}});
            },
            [this](const Expected<void>& noted) {
                if (!noted)
                    m_workbench->messages().report(noted.error().describe());
                reload();
            });
    });
}

} // namespace gripscope
