// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <chrono>
#include <functional>
#include <optional>

class QKeyEvent;
class QWidget;

namespace gripscope {

class Workbench;

/// Arms without a mouse: Ctrl+Shift+A, held for a second. A scanner is a keyboard, and whatever it types is
/// over in a moment; so is a key that is struck in passing. Letting any of the keys go, another key, a dialog
/// or another window ends it, and nothing was done. What follows is what the Arm button does, with all that
/// it asks.
class ArmChord : public QObject {
    Q_OBJECT
public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;
    static constexpr std::chrono::milliseconds duration{1000};

    /// Keys count anywhere in the window of `place`.
    ArmChord(Workbench& workbench, QWidget* place);
    ~ArmChord() override;
    void setClock(Clock clock); ///< for tests
    /// How far it is, 0 to 1; nothing while the keys are not held.
    [[nodiscard]] std::optional<double> progress() const;

signals:
    void changed(); ///< progress()

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void press(const QKeyEvent& key);
    void release(const QKeyEvent& key);
    void follow();
    void cancel();
    [[nodiscard]] bool possible() const;
    Workbench* m_workbench;
    QWidget* m_place;
    Clock m_clock;
    std::optional<std::chrono::steady_clock::time_point> m_since;
};

} // namespace gripscope
