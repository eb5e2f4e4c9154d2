// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/study_record.h"
#include "core/session/connection/loss_watch.h"

#include <QAbstractButton>
#include <QFrame>

class QLabel;
class QPushButton;

namespace gripscope {

class ArmChord;
class ConnectMenu;
class DeviceChip;
class ElidedLabel;
class Workbench;

/// An entry of the navigation rail: an icon over a word.
class RailButton : public QAbstractButton {
    Q_OBJECT
public:
    RailButton(const QString& text, const QString& icon, QWidget* parent = nullptr);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {sizeHint().width(), 56}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QString m_icon;
};

/// The row above every page: its title, the gripper, who works, armed or not, and Stop.
class HeaderBar : public QFrame {
    Q_OBJECT
public:
    explicit HeaderBar(Workbench& workbench, QWidget* parent = nullptr);
    void setTitle(const QString& title);

private:
    void refreshLink();
    void refreshArmed();
    void refreshHolding();
    Workbench* m_workbench;
    ArmChord* m_chord;
    QWidget* m_holding; ///< how long the keys that arm have been held
    LossWatch m_losses;
    QLabel *m_title, *m_stopped;
    DeviceChip* m_chip;
    ConnectMenu* m_menu;
    QPushButton* m_arm;
};

/// The line under every page: gripper, armed or not, latency, how its calibration and its check stand,
/// library and its version, counts.
class StatusLine : public QFrame {
    Q_OBJECT
public:
    explicit StatusLine(Workbench& workbench, QWidget* parent = nullptr);
    [[nodiscard]] QString text() const { return m_shown; }

private:
    void refresh();
    void askVersion();
    void askStudies();                          ///< where one may have been finished
    [[nodiscard]] QStringList standing() const; ///< of the connected gripper's channels and studies
    Workbench* m_workbench;
    ElidedLabel* m_label;
    QString m_shown;
    qint64 m_version = 0; ///< of the library; 0: not known yet
    std::vector<StudyRecord> m_studies;
    std::optional<bool> m_studyEnded; ///< when they were asked for
};

} // namespace gripscope
