// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connect_session.h"

#include <QAbstractButton>

namespace gripscope {

/// The gripper at a glance: a sign and a word for its state, name, rate and lost reports. Pressed, it opens
/// the menu to connect another.
class DeviceChip : public QAbstractButton {
    Q_OBJECT
public:
    explicit DeviceChip(QWidget* parent = nullptr);
    void setLink(ConnectSession::State state, const QString& words, const QString& detail);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {168, 40}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintState(QPainter& painter, const QPointF& centre) const;
    ConnectSession::State m_state = ConnectSession::State::Disconnected;
    QString m_words, m_detail;
};

} // namespace gripscope
