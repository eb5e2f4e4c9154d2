// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QFontInfo>
#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;

class ThemeTest : public QObject {
    Q_OBJECT
private slots:
    void contrastIsThatOfWcag();
    void everyWordReadsOnPageAndSurface_data();
    void everyWordReadsOnPageAndSurface();
    void typeColorsHoldThreeToOneOnLight();
    void outcomesDifferInLightAndDark();
    void iconsTakeTheColorAskedFor();
    void styleSheetHasNoUnknownName_data();
    void styleSheetHasNoUnknownName();
    void fontIsNotoSans();
};

void ThemeTest::contrastIsThatOfWcag()
{
    QCOMPARE(Theme::contrastRatio(Qt::black, Qt::white), 21.0);
    // #767676 is the well-known lightest grey that holds 4.5 on white.
    QVERIFY(Theme::contrastRatio(QColor(u"#767676"_s), Qt::white) >= 4.5);
    QVERIFY(Theme::contrastRatio(QColor(u"#777777"_s), Qt::white) < 4.5);
}

void ThemeTest::everyWordReadsOnPageAndSurface_data()
{
    QTest::addColumn<ThemeKind>("kind");
    QTest::newRow("light") << ThemeKind::Light;
    QTest::newRow("dark") << ThemeKind::Dark;
    QTest::newRow("contrast") << ThemeKind::HighContrast;
}

void ThemeTest::everyWordReadsOnPageAndSurface()
{
    QFETCH(ThemeKind, kind);
    const ThemeTokens t = themeTokens(kind);
    const std::pair<const char*, QColor> words[] = {
        {"text", t.text},       {"secondText", t.secondText}, {"accent", t.accent},
        {"stop", t.stop},       {"asExpected", t.asExpected}, {"otherType", t.otherType},
        {"unknown", t.unknown}, {"notValid", t.notValid},     {"inconclusive", t.inconclusive},
        {"suspect", t.suspect}, {"force", t.force},           {"position", t.position},
        {"model", t.model}};
    for (const auto& [name, color] : words) {
        QVERIFY2(Theme::contrastRatio(color, t.page) >= 4.5, name);
        QVERIFY2(Theme::contrastRatio(color, t.surface) >= 4.5, name);
    }
    QVERIFY(Theme::contrastRatio(Theme::onColor(t.stop), t.stop) >= 4.5);
    QVERIFY(Theme::contrastRatio(Theme::onColor(t.accent), t.accent) >= 4.5);
}

void ThemeTest::typeColorsHoldThreeToOneOnLight()
{
    const ThemeTokens light = themeTokens(ThemeKind::Light);
    for (int i = 0; i < 8; ++i) {
        QVERIFY(Theme::contrastRatio(Theme::typeColor(i), light.surface) >= 3.0);
        for (int j = 0; j < i; ++j)
            QVERIFY(Theme::typeColor(i) != Theme::typeColor(j));
    }
    QCOMPARE(Theme::typeColor(8), Theme::typeColor(0));
}

void ThemeTest::outcomesDifferInLightAndDark()
{
    for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark}) {
        const ThemeTokens t = themeTokens(kind);
        const QList<QColor> colors{t.asExpected, t.otherType, t.unknown, t.inconclusive, t.notValid, t.stop};
        for (qsizetype i = 0; i < colors.size(); ++i)
            QCOMPARE(colors.indexOf(colors[i]), i);
    }
}

void ThemeTest::iconsTakeTheColorAskedFor()
{
    Theme::instance().apply(ThemeKind::Light);
    const QIcon icon = Theme::instance().icon(u"help-about"_s, QColor(Qt::magenta));
    QVERIFY(!icon.isNull());
    const QImage image = icon.pixmap(64, 64).toImage().convertToFormat(QImage::Format_ARGB32);
    int painted = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            if (c.alpha() < 250)
                continue;
            ++painted;
            QVERIFY(c.red() > 240 && c.green() < 15 && c.blue() > 240);
        }
    QVERIFY(painted > 100);
    QVERIFY(Theme::instance().icon(u"no such icon"_s).isNull());
}

void ThemeTest::styleSheetHasNoUnknownName_data()
{
    everyWordReadsOnPageAndSurface_data();
}

void ThemeTest::styleSheetHasNoUnknownName()
{
    QFETCH(ThemeKind, kind);
    Theme::instance().apply(kind);
    QVERIFY(!qApp->styleSheet().contains(QLatin1Char('@')));
    QVERIFY(!qApp->styleSheet().contains(u"none;\n"_s + u"QComboBox::down-arrow { image: none"_s));
    QVERIFY(qApp->styleSheet().contains(Theme::instance().tokens().accent.name()));
}

void ThemeTest::fontIsNotoSans()
{
    QCOMPARE(QFontInfo(Theme::font(metrics::fontBase)).family(), u"Noto Sans"_s);
}

GRIPSCOPE_TEST(ThemeTest)
#include "theme_test.moc"
