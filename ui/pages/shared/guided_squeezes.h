// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QWidget>

#include <functional>

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace gripscope {

class SeriesSession;
class Workbench;

/// What all guided measurements with the gripper share (SeriesSession): how far it is, what was found so far,
/// what came out, and the one button that arms, squeezes, cancels or uses the result.
class GuidedSqueezes : public QWidget {
    Q_OBJECT
public:
    struct Script {
        QString name;                          ///< of the parts: "lag" makes lagAct and lagOutcome
        std::function<QString()> begin, again; ///< on the button
        std::function<QString()> obstacle;     ///< why it cannot begin; empty when it can
        std::function<Expected<void>()> start;
        std::function<QString()> found;   ///< what the squeezes so far say
        std::function<QString()> outcome; ///< once all are judged
        QString use;                      ///< on the button, where there is something to accept
        std::function<bool()> usable;
        std::function<Expected<void>()> accept;
    };
    GuidedSqueezes(Workbench& workbench, SeriesSession& session, Script script, QWidget* parent = nullptr);
    ~GuidedSqueezes() override;

    void addButton(QPushButton* button); ///< in front of its own
    [[nodiscard]] QPushButton* button() const { return m_act; }
    void refresh();
    void act();   ///< what the button does
    void leave(); ///< the person goes: nothing moves on

signals:
    void changed(); ///< the session did

private:
    void build();
    void enableAct(bool on);
    void claim(bool on); ///< tells the window that a squeeze is under way
    [[nodiscard]] QString outcome() const;
    [[nodiscard]] QString buttonText() const;
    [[nodiscard]] bool mayUse() const;

    Workbench* m_workbench;
    SeriesSession* m_session;
    Script m_script;
    bool m_claimed = false;
    QProgressBar* m_progress;
    QLabel *m_found, *m_outcome;
    QPushButton* m_act;
    QHBoxLayout* m_buttons;
};

} // namespace gripscope
