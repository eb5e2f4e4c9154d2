// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/layout_languages.h"
#include "tests/ui/layout_pages.h"
#include "ui/scene/scene_view.h"

using namespace Qt::StringLiterals;
using namespace gripscope::test;

/// Where the picture has three dimensions, its tools need more room than those of the flat one that the other
/// tests of layouts see.
class SceneLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void theTypesPage_data() { languageRows(); }
    void theTypesPage()
    {
        const RowLanguage language;
        WindowFixture f;
        f.window->showPage(u"types"_s);
        const auto* scene = f.window->findChild<gripscope::SceneWidget*>();
        QVERIFY(scene);
        LayoutWalk walk(*f.window);
        for (const NamedTheme& theme : everyTheme)
            for (const QSize size : {QSize(1440, 900), QSize(1024, 768), leastSize}) {
                gripscope::Theme::instance().apply(theme.first);
                f.window->resize(size);
                settleLayout();
                QTRY_VERIFY(scene->settled()); // in the colours of the theme
                walk.look(u"%1 %2"_s.arg(QLatin1String(theme.second)).arg(size.width()));
            }
        QVERIFY(walk.sound());
    }
};

GRIPSCOPE_TEST(SceneLayoutTest)
#include "scene_layout_test.moc"
