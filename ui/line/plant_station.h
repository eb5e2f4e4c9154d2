// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/link/plant_link.h"
#include "core/session/line/line_status.h"

#include <QObject>

namespace gripscope {

class Settings;
class Workbench;

/// Keeps the library of a station with a screen in step with its plant's server while the settings say so.
/// One a workbench.
class PlantStation : public QObject {
    Q_OBJECT
public:
    [[nodiscard]] static PlantStation& of(Workbench& workbench);
    ~PlantStation() override; ///< takes milliseconds
    [[nodiscard]] bool on() const { return m_on; }
    [[nodiscard]] LineWords words() const;

private:
    explicit PlantStation(Workbench& workbench);
    void configure();
    void noticeTypes();
    Workbench* m_workbench;
    std::unique_ptr<PlantLink> m_link;
    bool m_on = false;
    qint64 m_typesTaken = 0;
    std::optional<Error> m_problem; ///< of the settings
};

} // namespace gripscope
