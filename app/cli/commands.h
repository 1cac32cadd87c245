// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/App.hpp>
#include <memory>

#include "app/session/session.h"

namespace angiomesh::cli {

/// Has the command run body(options, progress).
template <class Options, class Body>
void setAction(CLI::App* command, Session& session, const std::shared_ptr<Options>& options,
               const Body& body) {
  command->callback([options, &session, body] {
    session.action = [options, &session, body] { return body(*options, session.progress); };
  });
}

// Each adds one command to the program; parsing it sets session.action.

void addRun(CLI::App& program, Session& session);

void addInfo(CLI::App& program, Session& session);
void addPhantom(CLI::App& program, Session& session);
void addConvert(CLI::App& program, Session& session);

void addVesselness(CLI::App& program, Session& session);
void addSegment(CLI::App& program, Session& session);
void addMesh(CLI::App& program, Session& session);
void addSmooth(CLI::App& program, Session& session);

void addQuality(CLI::App& program, Session& session);
void addEvaluate(CLI::App& program, Session& session);
void addSkeleton(CLI::App& program, Session& session);

void addParameters(CLI::App& program, Session& session);

// Of angiomesh-pictures, which angiomesh-cli runs for them.
constexpr const char* kSnapshotText =
    "A rendered picture of a result (needs an X display, a virtual one will do)";
constexpr const char* kStudyText = "The thesis's tables and figures, made anew, and the evidence";
void addSnapshot(CLI::App& program, Session& session);
void addStudy(CLI::App& program, Session& session);

}  // namespace angiomesh::cli
