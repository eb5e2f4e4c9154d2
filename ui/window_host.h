// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <memory>

namespace gripscope {

class MainWindow;
class Workbench;

/// Owns the window: opens it as it was left, keeps how it is left, and builds it anew in another language.
/// The sessions of the workbench know nothing of it and go on.
class WindowHost : public QObject {
    Q_OBJECT
public:
    explicit WindowHost(Workbench& workbench, QObject* parent = nullptr);
    ~WindowHost() override;
    [[nodiscard]] MainWindow& window() const { return *m_window; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void rebuild();
    void keepState();
    Workbench* m_workbench;
    std::unique_ptr<MainWindow> m_window;
};

} // namespace gripscope
