// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/latency_histogram.h"

#include <QFrame>

#include <map>
#include <optional>

class QGridLayout;

namespace gripscope {

class ElidedLabel;
class Workbench;

/// The link at a glance: is it there, how fast, what was lost and when, how old is what the screen shows; and
/// whether the gripper may move, how far, and whether it does.
class LiveLinkPanel : public QFrame {
    Q_OBJECT
public:
    explicit LiveLinkPanel(Workbench& workbench, QWidget* parent = nullptr);

    /// The newest sample is on the screen now: its age counts as the latency.
    void notePainted();
    void refresh();
    /// What stands under a caption: link, reports, samples, lost, latency, armed, force, travel, excitation,
    /// stream.
    [[nodiscard]] QString text(const QString& id) const;

private:
    void add(QGridLayout* grid, const QString& id, const QString& caption, int row, int column);
    void set(const QString& id, const QString& text);
    void refreshStream();
    void refreshGripper();
    Workbench* m_workbench;
    std::map<QString, ElidedLabel*> m_values;
    std::map<QString, QString> m_texts;
    LatencyHistogram m_painted;
    std::optional<LatencyHistogram::TimePoint> m_paintedArrival; ///< of the newest sample on the screen
};

} // namespace gripscope
