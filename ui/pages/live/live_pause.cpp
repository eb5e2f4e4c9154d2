// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/live/live_pause.h"

#include "core/session/connection/described_recording.h"
#include "ui/charts/strip_chart.h"
#include "ui/context/workbench.h"
#include "ui/format/cursor_reading.h"
#include "ui/pages/live/live_cards.h"
#include "ui/pages/live/live_recording.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
constexpr double leastSamples = 20; ///< in view, however close one looks
}

LivePause::LivePause(Workbench& workbench, LiveChannelCard& force, LiveChannelCard& position,
                     LiveMarkerModel& markers, QWidget* page)
    : QObject(page), m_workbench(&workbench), m_force(&force), m_position(&position), m_markers(&markers),
      m_panel(new LiveMeasurePanel(markers, page))
{
    m_panel->hide();
    connectCharts();
    connectPanel();
    for (const auto& changed : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(m_markers, changed, this, &LivePause::refreshMarks);
    connect(m_markers, &QAbstractItemModel::modelReset, this, &LivePause::refreshMarks);
}

void LivePause::connectCharts()
{
    for (LiveChannelCard* card : cards()) {
        auto* gestures = new StripGestures(card->chart());
        connect(gestures, &StripGestures::zoomAsked, this, &LivePause::zoom);
        connect(gestures, &StripGestures::panAsked, this, &LivePause::pan);
        connect(gestures, &StripGestures::resetAsked, this, &LivePause::reset);
        connect(gestures, &StripGestures::cursorStepped, this, &LivePause::stepCursor);
        connect(gestures, &StripGestures::cursorDragged, this, [this](int cursor, double share) {
            setCursor(cursor, m_view.from_s() + std::clamp(share, 0.0, 1.0) * m_view.seconds());
        });
        m_gestures.push_back(gestures);
    }
}

void LivePause::connectPanel()
{
    connect(m_panel, &LiveMeasurePanel::zoomAsked, this, [this](double factor) { zoom(factor); });
    connect(m_panel, &LiveMeasurePanel::panAsked, this, &LivePause::pan);
    connect(m_panel, &LiveMeasurePanel::resetAsked, this, &LivePause::reset);
    connect(m_panel, &LiveMeasurePanel::cursorsAsked, this, &LivePause::bringCursors);
    connect(m_panel, &LiveMeasurePanel::saveAsked, this, &LivePause::saveAsked);
    connect(m_panel, &LiveMeasurePanel::cursorSet, this,
            [this](int cursor, double time_s) { setCursor(cursor, m_view.reference_s() + time_s); });
    connect(m_panel, &LiveMeasurePanel::markerChosen, this, [this](int row) {
        m_view.show(m_markers->markers()[static_cast<std::size_t>(row)].time_s);
        refreshView();
    });
}

const LiveHistory& LivePause::history() const
{
    return m_held ? *m_held : m_workbench->live().history();
}

void LivePause::setHeld(bool on)
{
    if (on == held())
        return;
    if (on) {
        m_held = m_workbench->live().history();
        m_heldAt = QDateTime::currentDateTime();
        m_heldLink = m_workbench->connection().reconnections();
        m_described = describedRecording(m_workbench->connection(), m_workbench->operatorName(), {});
        m_view.hold(m_held->oldestTime_s(), m_held->newestTime_s(), leastSamples * m_held->sampleTime_s());
        m_movedLast = 0;
        bringCursors();
    } else {
        m_held.reset();
        m_view.release();
    }
    for (StripGestures* gestures : m_gestures)
        gestures->setEnabled(on);
    m_panel->setVisible(on);
    refreshView();
}

void LivePause::setSpan(double seconds)
{
    m_view.setSpan(seconds);
    keepCursorsInView();
    refreshView();
}

void LivePause::zoom(double factor, double share)
{
    m_view.zoom(factor, share);
    keepCursorsInView();
    refreshView();
}

void LivePause::pan(double share)
{
    m_view.pan(share);
    keepCursorsInView();
    refreshView();
}

void LivePause::reset()
{
    m_view.reset();
    keepCursorsInView();
    refreshView();
}

void LivePause::setCursor(int cursor, double time_s)
{
    const double oldest_s = std::min(history().oldestTime_s(), m_view.from_s());
    m_cursors_s[static_cast<std::size_t>(cursor)] = std::clamp(time_s, oldest_s, m_view.reference_s());
    m_movedLast = cursor;
    m_view.show(m_cursors_s[static_cast<std::size_t>(cursor)]);
    refreshView();
}

void LivePause::stepCursor(int cursor, int columns)
{
    const double column_s = m_view.seconds() / m_force->chart().columns();
    // Where a sample is wider than a column, a step that shows nothing new would be none.
    const double step_s = std::max(column_s, history().sampleTime_s());
    setCursor(cursor, m_cursors_s[static_cast<std::size_t>(cursor)] + columns * step_s);
}

void LivePause::bringCursors()
{
    placeCursors();
    refreshView();
}

void LivePause::placeCursors()
{
    m_cursors_s = {m_view.from_s() + m_view.seconds() / 4, m_view.from_s() + 3 * m_view.seconds() / 4};
}

/// One that the view has left waits at its edge, where it can be taken; both would stand on each other there.
void LivePause::keepCursorsInView()
{
    const auto outside = [this](double time_s) {
        return time_s < m_view.from_s() || time_s > m_view.until_s();
    };
    if (!held())
        return;
    if (outside(m_cursors_s[0]) && outside(m_cursors_s[1]))
        return placeCursors();
    for (double& time_s : m_cursors_s)
        time_s = std::clamp(time_s, m_view.from_s(), m_view.until_s());
}

LiveMarker LivePause::marker() const
{
    LiveMarker marker;
    marker.time_s = history().newestTime_s();
    marker.when = QDateTime::currentDateTime();
    marker.link = m_workbench->connection().reconnections();
    if (held()) {
        marker.time_s = m_cursors_s[static_cast<std::size_t>(m_movedLast)];
        marker.when = m_heldAt.addMSecs(-std::llround(1000 * (m_view.reference_s() - marker.time_s)));
        marker.link = m_heldLink;
    }
    if (const std::optional<Sample> sample = history().sampleAt(marker.time_s))
        marker.sequence = sample->sequence;
    return marker;
}

Recording LivePause::recordingInView() const
{
    return recordingOf(history(), m_view.from_s(), m_view.until_s(), m_described, m_markers->markers());
}

void LivePause::refreshCharts()
{
    m_view.follow(history().newestTime_s());
    for (LiveChannelCard* card : cards())
        card->refreshChart(history(), m_view);
    refreshMarks();
}

void LivePause::refreshView()
{
    refreshCharts();
    if (held())
        refreshReadout();
}

void LivePause::refreshMarks()
{
    std::vector<StripMark> marks;
    for (const LiveMarker& marker : m_markers->markers())
        if (marker.time_s >= m_view.from_s() && marker.time_s <= m_view.until_s())
            marks.push_back({marker.time_s - m_view.until_s(), QString::number(marker.number)});
    if (held()) {
        marks.push_back(
            {m_cursors_s[0] - m_view.until_s(), tr("A", "first cursor"), StripMark::Kind::FirstCursor});
        marks.push_back(
            {m_cursors_s[1] - m_view.until_s(), tr("B", "second cursor"), StripMark::Kind::SecondCursor});
    }
    for (LiveChannelCard* card : cards())
        card->chart().setMarks(marks);
}

void LivePause::refreshReadout()
{
    const double reference_s = m_view.reference_s();
    const CursorReading a = readCursor(*m_held, m_cursors_s[0]);
    const CursorReading b = readCursor(*m_held, m_cursors_s[1]);
    const auto texts = [&](double time_s, const CursorReading& reading) {
        return LiveMeasurePanel::CursorTexts{time_s - reference_s, m_force->readingText(reading.force),
                                             m_position->readingText(reading.position)};
    };
    LiveMeasurePanel::Readout readout;
    readout.cursors = {texts(m_cursors_s[0], a), texts(m_cursors_s[1], b)};
    readout.time =
        formatNumber(m_cursors_s[1] - m_cursors_s[0], m_held->sampleTime_s(), u"s"_s).valueWithUnit();
    readout.force = m_force->changeText(difference(a.force, b.force));
    readout.position = m_position->changeText(difference(a.position, b.position));
    const std::optional<ReadValue> slope = slopeBetween(a, b);
    readout.slope = slope ? slopeText(*slope, m_described.forceUnit, m_described.positionUnit).text()
                          : tr("position does not change");
    m_panel->setTimes(std::min(m_held->oldestTime_s(), m_view.from_s()) - reference_s,
                      std::max(m_view.seconds() / 100, m_held->sampleTime_s()));
    m_panel->show(readout);
}

} // namespace gripscope
