// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QTextBrowser;

namespace gripscope {

/// The manual that is compiled in, with links between its pages.
class ManualDialog : public QDialog {
    Q_OBJECT
public:
    /// At the page for a screen, by that screen's id.
    explicit ManualDialog(const QString& screen, QWidget* parent = nullptr);
    [[nodiscard]] QTextBrowser* browser() const { return m_browser; }

private:
    QTextBrowser* m_browser;
};

/// The manual's page about a screen: "identification.md"; the contents where it has none.
[[nodiscard]] QString manualPageFor(const QString& screen);

} // namespace gripscope
