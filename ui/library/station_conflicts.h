// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/plant/plant_conflict.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace gripscope {

class Workbench;

/// Tells the message bar what stations decided apart and no supervisor has seen, once the library has said
/// it.
void tellStationConflicts(Workbench& bench, QObject* window);

/// The same in the dialog of the library, until somebody who may decide it says that they have seen it;
/// hidden where there is nothing.
class StationConflicts : public QWidget {
    Q_OBJECT
public:
    explicit StationConflicts(Workbench& workbench, QWidget* parent = nullptr);

private:
    void reload();
    void put(std::vector<PlantConflict> conflicts);
    void markSeen();
    Workbench* m_workbench;
    QLabel* m_text;
    QPushButton* m_seen;
    std::vector<PlantConflict> m_conflicts;
};

} // namespace gripscope
