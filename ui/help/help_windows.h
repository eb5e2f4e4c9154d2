// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/windows/dialog.h"

#include <QString>
#include <QTextBrowser>

#include <vector>

class QBoxLayout;
class QLineEdit;
class QListWidget;

namespace gripscope {

/// A page of the manual that is compiled in (resources/manual), in the language in force.
struct ManualPage {
    QString file; ///< "inspect.md"
    QString title, text;
};

/// Where a page is, ":/manual/de/inspect.md": in English where the language has no page of its own.
[[nodiscard]] QString manualPath(const QString& file);
/// All pages in the order of the table of contents, which comes first.
[[nodiscard]] std::vector<ManualPage> manualPages();
/// Whether all of these words, or beginnings of words, stand on the page.
[[nodiscard]] bool speaksOf(const ManualPage& page, const QString& words);
/// The page about a screen, by the screen's id; the contents where it has none.
[[nodiscard]] QString manualPageFor(const QString& screen);

/// Shows a page of the manual. Its pictures are made as wide as a column of text and stay sharp.
class ManualBrowser : public QTextBrowser {
    Q_OBJECT
public:
    explicit ManualBrowser(QWidget* parent = nullptr);
    void showPage(const QString& file); ///< "inspect.md"
    [[nodiscard]] QString page() const;

signals:
    void pageShown(const QString& file);

protected:
    void changeEvent(QEvent* event) override;
    void doSetSource(const QUrl& name, QTextDocument::ResourceType type) override;
    QVariant loadResource(int type, const QUrl& name) override;

private:
    void spaceOut(); ///< as a page of print: Markdown comes without air between its blocks
};

/// The manual beside the work: its pages, found by any of their words, and the one chosen.
class ManualWindow : public Dialog {
    Q_OBJECT
public:
    explicit ManualWindow(QWidget* parent = nullptr);
    void showPage(const QString& file); ///< "inspect.md"
    [[nodiscard]] ManualBrowser* browser() const { return m_browser; }

signals:
    void keysAsked(); ///< the list of keys, and what this program is

private:
    void buildSide(QBoxLayout* row);
    void buildButtons(QBoxLayout* column);
    void filter();
    void followBrowser();

    std::vector<ManualPage> m_pages;
    QLineEdit* m_words;
    QListWidget* m_list;
    ManualBrowser* m_browser;
};

/// What the program is, which version, and every key that does something.
class AboutDialog : public Dialog {
    Q_OBJECT
public:
    explicit AboutDialog(const QStringList& pageTitles, QWidget* parent = nullptr);
};

} // namespace gripscope
