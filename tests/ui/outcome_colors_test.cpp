// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/theme/theme.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

Triple times(const Matrix& matrix, const Triple& v)
{
    Triple out{};
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
    return out;
}

/// sRGB (IEC 61966-2-1), each 0 to 1, proportional to light.
Triple linear(const QColor& color)
{
    const auto part = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return {part(color.redF()), part(color.greenF()), part(color.blueF())};
}

/// What eyes without green cones take for the same: Machado, Oliveira and Fernandes, A physiologically-based
/// model for simulation of color vision deficiency, IEEE TVCG 15 (2009), deuteranomaly of severity 1.
Triple withoutGreen(const Triple& rgb)
{
    constexpr Matrix matrix{
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
    Triple seen = times(matrix, rgb);
    for (double& part : seen)
        part = std::clamp(part, 0.0, 1.0);
    return seen;
}

/// CIE 1976 L*a*b* for the white of D65.
Triple lab(const Triple& rgb)
{
    constexpr Matrix toXyz{{{0.4124564, 0.3575761, 0.1804375},
                            {0.2126729, 0.7151522, 0.0721750},
                            {0.0193339, 0.1191920, 0.9503041}}};
    constexpr Triple white{0.95047, 1, 1.08883};
    const Triple xyz = times(toXyz, rgb);
    Triple f{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double t = xyz[i] / white[i];
        f[i] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

constexpr double degree = std::numbers::pi / 180;

double hue(double a, double b)
{
    const double angle = a == 0 && b == 0 ? 0 : std::atan2(b, a) / degree;
    return angle < 0 ? angle + 360 : angle;
}

/// CIE Delta E 2000, after Sharma, Wu and Dalal, The CIEDE2000 color-difference formula, Color Research and
/// Application 30 (2005).
double difference(const Triple& one, const Triple& other)
{
    const double chroma = (std::hypot(one[1], one[2]) + std::hypot(other[1], other[2])) / 2;
    const auto seventh = [](double c) {
        return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + std::pow(25, 7)));
    };
    const double a1 = one[1] * (1 + 0.5 * (1 - seventh(chroma)));
    const double a2 = other[1] * (1 + 0.5 * (1 - seventh(chroma)));
    const double c1 = std::hypot(a1, one[2]), c2 = std::hypot(a2, other[2]);
    const double h1 = hue(a1, one[2]), h2 = hue(a2, other[2]);
    const bool grey = c1 * c2 == 0;
    double turn = grey ? 0 : h2 - h1;
    if (turn > 180)
        turn -= 360;
    else if (turn < -180)
        turn += 360;
    const double lightness = (one[0] + other[0]) / 2, c = (c1 + c2) / 2;
    double h = h1 + h2;
    if (!grey && std::abs(h1 - h2) > 180)
        h += h < 360 ? 360 : -360;
    if (!grey)
        h /= 2;
    const double t = 1 - 0.17 * std::cos((h - 30) * degree) + 0.24 * std::cos(2 * h * degree) +
                     0.32 * std::cos((3 * h + 6) * degree) - 0.2 * std::cos((4 * h - 63) * degree);
    const double fromMiddle = std::pow(lightness - 50, 2);
    const double dL = (other[0] - one[0]) / (1 + 0.015 * fromMiddle / std::sqrt(20 + fromMiddle));
    const double dC = (c2 - c1) / (1 + 0.045 * c);
    const double dH = 2 * std::sqrt(c1 * c2) * std::sin(turn / 2 * degree) / (1 + 0.015 * c * t);
    const double rotation = -2 * seventh(c) * std::sin(60 * std::exp(-std::pow((h - 275) / 25, 2)) * degree);
    return std::sqrt(dL * dL + dC * dC + dH * dH + rotation * dC * dH);
}

} // namespace

Q_DECLARE_METATYPE(Triple)

/// The five outcomes in each theme: nobody takes one for another at a glance. Signs and words tell them apart
/// without colour; a doubt about any of them has stripes too, and is not held to this.
class OutcomeColorsTest : public QObject {
    Q_OBJECT
private slots:
    void theDifferenceIsThatOfTheStandard_data()
    {
        QTest::addColumn<Triple>("one");
        QTest::addColumn<Triple>("other");
        QTest::addColumn<double>("found");
        // Of the table of test data of Sharma, Wu and Dalal: its pairs 1, 7, 11, 17, 20, 25 and 33.
        QTest::newRow("1") << Triple{50, 2.6772, -79.7751} << Triple{50, 0, -82.7485} << 2.0425;
        QTest::newRow("7") << Triple{50, 0, 0} << Triple{50, -1, 2} << 2.3669;
        QTest::newRow("11") << Triple{50, 2.4900, -0.0010} << Triple{50, -2.4900, 0.0011} << 7.2195;
        QTest::newRow("17") << Triple{50, 2.5, 0} << Triple{73, 25, -18} << 27.1492;
        QTest::newRow("20") << Triple{50, 2.5, 0} << Triple{58, 24, 15} << 19.4535;
        QTest::newRow("25") << Triple{60.2574, -34.0099, 36.2677} << Triple{60.4626, -34.1751, 39.4387}
                            << 1.2644;
        QTest::newRow("33") << Triple{6.7747, -0.2908, -2.4247} << Triple{5.8714, -0.0985, -2.2286} << 0.6377;
    }
    void theDifferenceIsThatOfTheStandard()
    {
        QFETCH(Triple, one);
        QFETCH(Triple, other);
        QFETCH(double, found);
        QVERIFY2(std::abs(difference(one, other) - found) < 1e-4,
                 qPrintable(QString::number(difference(one, other), 'f', 4)));
        QVERIFY(std::abs(difference(other, one) - found) < 1e-4);
    }

    void noTwoAreAlike_data()
    {
        QTest::addColumn<ThemeKind>("theme");
        QTest::newRow("light") << ThemeKind::Light;
        QTest::newRow("dark") << ThemeKind::Dark;
        QTest::newRow("contrast") << ThemeKind::HighContrast;
    }
    void noTwoAreAlike()
    {
        QFETCH(ThemeKind, theme);
        constexpr double least = 20, leastWithoutGreen = 10; // a just noticeable difference is about 1
        const ThemeTokens t = themeTokens(theme);
        const std::pair<const char*, QColor> colors[] = {
            {"as expected", t.asExpected}, {"other type", t.otherType},
            {"unknown", t.unknown},        {"inconclusive", t.inconclusive},
            {"not valid", t.notValid},     {"does not conform", t.doesNotConform}};
        for (const auto& [name, color] : colors)
            for (const auto& [otherName, other] : colors) {
                if (color == other)
                    continue;
                const Triple a = linear(color), b = linear(other);
                const double seen = difference(lab(a), lab(b));
                const double without = difference(lab(withoutGreen(a)), lab(withoutGreen(b)));
                QVERIFY2(seen >= least && without >= leastWithoutGreen,
                         qPrintable(u"%1, %2: %3, without green %4"_s
                                        .arg(QString::fromLatin1(name), QString::fromLatin1(otherName))
                                        .arg(seen)
                                        .arg(without)));
            }
    }
};

GRIPSCOPE_TEST(OutcomeColorsTest)
#include "outcome_colors_test.moc"
