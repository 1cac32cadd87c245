// SPDX-License-Identifier: BSD-3-Clause
#include "gui/findings/measurement_text.h"

#include <QLocale>
#include <algorithm>

#include "core/measure/vessel_profile.h"
#include "gui/findings/case_measures.h"

namespace angiomesh {

namespace {

QString number(double value) { return QLocale().toString(value, 'f', 2); }
/// Number and sign stay in one line.
QString percent(double share) {
  return QLocale().toString(100.0 * share, 'f', 0) + QStringLiteral("\u00a0%");
}

QString sectionText(const CrossSection& section) {
  return QObject::tr("Ø min %1, max %2, of the area %3 mm; area %4 mm²")
      .arg(number(section.minDiameterMm()), number(section.maxDiameterMm()),
           number(section.equivalentDiameterMm()), number(section.areaMm2));
}

QString profileText(const std::vector<ProfilePoint>& profile) {
  double least = profile.front().diameterMm, greatest = least, sum = 0.0;
  for (const ProfilePoint& point : profile) {
    least = std::min(least, point.diameterMm);
    greatest = std::max(greatest, point.diameterMm);
    sum += point.diameterMm;
  }
  return QObject::tr("Ø %1 to %2, mean %3 mm, along %4 mm")
      .arg(number(least), number(greatest), number(sum / static_cast<double>(profile.size())),
           number(profile.back().alongMm - profile.front().alongMm));
}

/// "NASCET = 1 − D / D distal = 1 − 1.20 mm / 2.40 mm = 50 %".
QString formula(const QString& name, const QString& letter, const QString& reference, double value,
                double of, const QString& unit, double share) {
  return QStringLiteral("%1 = 1 − %2 / %2 %3 = 1 − %4 %6 / %5 %6 = %7")
      .arg(name, letter, reference, number(value), number(of), unit, percent(share));
}

QString stenosisDetails(const Measurement& m) {
  const CrossSection &narrow = m.sections[0], &proximal = m.sections[1], &distal = m.sections[2];
  const StenosisDegree degree = stenosisDegree(m);
  const QString diameter = QObject::tr("D", "a least diameter");
  const QString area = QObject::tr("A", "an area");
  const QStringList lines{
      formula(QObject::tr("NASCET"), diameter, CaseMeasures::tr("distal"), narrow.minDiameterMm(),
              distal.minDiameterMm(), QStringLiteral("mm"), degree.nascet),
      formula(QObject::tr("WASID"), diameter, CaseMeasures::tr("proximal"), narrow.minDiameterMm(),
              proximal.minDiameterMm(), QStringLiteral("mm"), degree.wasid),
      formula(QObject::tr("By area"), area, CaseMeasures::tr("distal"), narrow.areaMm2,
              distal.areaMm2, QStringLiteral("mm²"), degree.area),
      QObject::tr("D, A: least diameter and area of the narrowest section between the two "
                  "places. Proximal is the place that was clicked first, distal the second.")};
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

QString measurementTitle(MeasurementKind kind) {
  switch (kind) {
    case MeasurementKind::Distance:
      return QObject::tr("Distance");
    case MeasurementKind::Section:
      return QObject::tr("Section");
    case MeasurementKind::Profile:
      return QObject::tr("Branch");
    case MeasurementKind::Stenosis:
      return QObject::tr("Stenosis");
  }
  return {};
}

QString measurementHint(MeasurementKind kind, std::size_t picked) {
  switch (kind) {
    case MeasurementKind::Distance:
      return picked == 0 ? QObject::tr("Click the two ends of a distance.")
                         : QObject::tr("Click the other end.");
    case MeasurementKind::Section:
      return QObject::tr("Click a vessel where it is to be cut across.");
    case MeasurementKind::Profile:
      return QObject::tr("Click a branch to see its diameter from end to end.");
    case MeasurementKind::Stenosis:
      return picked == 0 ? QObject::tr(
                               "Click the vessel where it is normal, first on the side that "
                               "the blood comes from, then behind the narrowing.")
                         : QObject::tr(
                               "Click the vessel where it is normal again, behind the "
                               "narrowing.");
  }
  return {};
}

QString measurementValue(const Measurement& m) {
  switch (m.kind) {
    case MeasurementKind::Distance:
      return QObject::tr("%1 mm").arg(number((m.places[1] - m.places[0]).norm()));
    case MeasurementKind::Section:
      return sectionText(m.sections[0]);
    case MeasurementKind::Profile:
      return profileText(m.profile);
    case MeasurementKind::Stenosis: {
      const StenosisDegree degree = stenosisDegree(m);
      return QObject::tr("NASCET %1, WASID %2, by area %3")
          .arg(percent(degree.nascet), percent(degree.wasid), percent(degree.area));
    }
  }
  return {};
}

QString measurementDetails(const Measurement& m) {
  switch (m.kind) {
    case MeasurementKind::Distance:
      return QObject::tr("In a straight line from one place to the other.");
    case MeasurementKind::Section:
      return QObject::tr(
          "Across the vessel's axis. Min: the least distance of two parallel lines that hold the "
          "outline between them. Max: the greatest distance of two of its points. Of the area: "
          "the circle that is as large, √(4 A / π).");
    case MeasurementKind::Profile:
      return QObject::tr(
          "Diameter of the circle as large as the section across the centre line, from end to end "
          "of the branch; thin: least diameter. Left out where vessels part.");
    case MeasurementKind::Stenosis:
      return stenosisDetails(m);
  }
  return {};
}

}  // namespace angiomesh
