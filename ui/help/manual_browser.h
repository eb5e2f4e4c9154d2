// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextBrowser>

namespace gripscope {

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
    void doSetSource(const QUrl& name, QTextDocument::ResourceType type) override;
    QVariant loadResource(int type, const QUrl& name) override;

private:
    void spaceOut(); ///< as a page of print: Markdown comes without air between its blocks
};

} // namespace gripscope
