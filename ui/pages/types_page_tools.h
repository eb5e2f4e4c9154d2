// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;
class QToolButton;

namespace gripscope {

class SceneView;

/// Above the scene: which types, from where to look, the picture for elsewhere.
class SceneToolBar : public QWidget {
    Q_OBJECT
public:
    explicit SceneToolBar(SceneView* view, QWidget* parent = nullptr);

    void setPaper(bool paper);

signals:
    void paperAsked(bool paper);         ///< the paper's tables, or the library
    void failed(const QString& message); ///< the picture could not be written

private:
    void savePicture();

    SceneView* m_view;
    QComboBox* m_source;
    QToolButton* m_orthographic = nullptr;
};

} // namespace gripscope
