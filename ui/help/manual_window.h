// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/help/manual_pages.h"

#include <QDialog>

class QLineEdit;
class QListWidget;

namespace gripscope {

class ManualBrowser;

/// The manual beside the work: its pages, found by any of their words, and the one chosen.
class ManualWindow : public QDialog {
    Q_OBJECT
public:
    explicit ManualWindow(QWidget* parent = nullptr);
    void showPage(const QString& file); ///< "inspect.md"
    [[nodiscard]] ManualBrowser* browser() const { return m_browser; }

signals:
    void keysAsked(); ///< the list of keys, and what this program is

private:
    void buildSide(class QBoxLayout* row);
    void buildButtons(class QBoxLayout* column);
    void filter();
    void followBrowser();

    std::vector<ManualPage> m_pages;
    QLineEdit* m_words;
    QListWidget* m_list;
    ManualBrowser* m_browser;
};

} // namespace gripscope
