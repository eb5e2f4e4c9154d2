// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>

#include <functional>
#include <vector>

namespace gripscope {

class Workbench;

/// What every window but the main one is. None is modal to the desktop: a modal window would keep presses
/// from the STOP of the others. WindowGuard gives it a STOP of its own and, while it asks, keeps input from
/// the other windows but for their STOPs.
///
/// Each class of dialogs has a row in the table (RegisteredDialog), by which tests meet it; this is checked
/// when CMake configures (packaging/cmake/windows_rule.cmake).
class Dialog : public QDialog {
    Q_OBJECT
public:
    enum class Conduct {
        Asks,   ///< the other windows wait until it is closed
        Beside, ///< the other windows go on
        Reads,  ///< and it goes on while others ask: it can change nothing
    };
    /// Over the window that `parent` is in.
    explicit Dialog(QWidget* parent, Conduct conduct = Conduct::Asks);

    [[nodiscard]] Conduct conduct() const { return m_conduct; }
    /// The page of the manual that F1 opens here ("settings"); empty: the one about the screen under it.
    [[nodiscard]] const QString& manualPage() const { return m_manualPage; }
    void setManualPage(const QString& page) { m_manualPage = page; }
    /// Shows it and returns at once; accepted() or rejected() tell the answer.
    void open() override;

protected:
    /// Grows as its words do: lines that wrap have no least height that a window would keep by itself.
    bool event(QEvent* event) override;

private:
    Conduct m_conduct;
    QString m_manualPage;
};

/// A class of dialogs, by its name, and how to make one over a window for a look at it.
struct DialogRow {
    const char* name;
    std::function<QDialog*(Workbench&, QWidget* over)> make;
};
[[nodiscard]] std::vector<DialogRow>& dialogTable();

/// Put beside the class, at namespace scope.
template <typename Class>
struct RegisteredDialog {
    RegisteredDialog(const char* name, std::function<QDialog*(Workbench&, QWidget*)> make)
    {
        dialogTable().push_back({name, std::move(make)});
    }
};

} // namespace gripscope
