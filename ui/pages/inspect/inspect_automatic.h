// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect/automatic_squeeze.h"

#include <QObject>
#include <QString>

#include <chrono>

namespace gripscope {

class VerdictPanel;
class Workbench;

/// The automatic squeeze of the Inspect page: hands samples, time and what a person does to AutomaticSqueeze,
/// and says what comes of it. It squeezes nothing itself.
class InspectAutomatic : public QObject {
    Q_OBJECT
public:
    explicit InspectAutomatic(Workbench& workbench, QObject* parent = nullptr);
    ~InspectAutomatic() override;

    /// Whether keys and clicks are seen; behind all that take them.
    void setActive(bool active);
    [[nodiscard]] bool wanted() const; ///< by the settings
    /// `ready`: the page is shown, nothing asks, and Space would squeeze now. To be called at each tick.
    void follow(bool ready);
    void squeezedByHand() { m_machine.squeezedByHand(); }

    [[nodiscard]] bool counting() const;
    void show(VerdictPanel& panel) const; ///< while it counts
    [[nodiscard]] QString words() const;  ///< what it waits for

signals:
    void due();     ///< to be squeezed now
    void changed(); ///< what show() and words() say
    void beat();    ///< each half second of a countdown

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setOptions();
    Workbench* m_workbench;
    AutomaticSqueeze m_machine;
    AutomaticSqueeze::Decision m_now;
    int m_listener = 0, m_beats = 0;
    bool m_armed = false;
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

} // namespace gripscope
