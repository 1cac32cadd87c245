// SPDX-License-Identifier: BSD-3-Clause
#include "gui/patient_identity.h"

#include <QMessageBox>
#include <exception>
#include <utility>

namespace angiomesh {

void IdentityJob::execute() noexcept {
  try {
    found = readIdentity(origin);
  } catch (const std::exception& failure) {
    error = failure.what();
  }
}

PatientIdentity::PatientIdentity(QWidget* window, CaseModels& models,
                                 const JobRunnerFactory& makeRunner)
    : QObject(window),
      window_(window),
      models_(models),
      slot_(models.timer, makeRunner,
            [this](const std::shared_ptr<IdentityJob>& job) { finish(*job); }) {}

void PatientIdentity::show() {
  const auto origin = models_.files.dicomOrigin();
  if (!origin || slot_) return;
  auto job = std::make_shared<IdentityJob>();
  job->origin = *origin;
  slot_.start(std::move(job));
}

void PatientIdentity::finish(const IdentityJob& job) {
  QString text;
  const auto add = [&text](const QString& title, const std::string& value) {
    const QString shown = value.empty() ? QStringLiteral("–") : QString::fromStdString(value);
    text += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td><b>%2</b></td></tr>")
                .arg(title.toHtmlEscaped(), shown.toHtmlEscaped());
  };
  add(tr("Name"), job.found.name);
  add(tr("Patient ID"), job.found.id);
  add(tr("Born"), job.found.birthDate);
  add(tr("Sex"), job.found.sex);
  add(tr("Study date"), job.found.studyDate);
  add(tr("Study"), job.found.studyDescription);
  add(tr("Accession number"), job.found.accession);
  auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Patient of this scan"), {},
                              QMessageBox::Close, window_);
  box->setObjectName("identityBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  if (job.error.empty()) {
    box->setText(QStringLiteral("<table>%1</table>").arg(text));
    box->setInformativeText(tr("Read from the files now. Angiomesh keeps none of it."));
  } else {
    box->setText(tr("Cannot read the patient's identity: %1").arg(job.error.c_str()));
  }
  box->open();
}

}  // namespace angiomesh
