// SPDX-License-Identifier: BSD-3-Clause
// Edits, saves and caches a case as the desktop does, for kill_cases.sh to kill, and tells what a
// case holds.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <random>
#include <stdexcept>

#include "bench/program.h"
#include "core/parameters/field.h"
#include "gui/job/case_store.h"

namespace angiomesh::bench {
namespace {

namespace fs = std::filesystem;

/// So many that a journal of some ten edits is cut.
constexpr std::size_t kSeeds = 400;
/// Results of older edits than that are not looked for.
constexpr int kOldest = 40;

struct Places {
  fs::path folder, recoveries;
};

/// Several parameters tell the number, so that a mixture of two edits shows. 0: not edited yet.
Parameters parametersOf(int number) {
  Parameters params = preset("angiomesh");
  if (number == 0) return params;
  params.levelset.maxIterations = number;
  params.seeds.points.assign(3 * kSeeds, static_cast<double>(number));
  return params;
}

int numberOf(const Parameters& params) {
  const auto& seeds = params.seeds.points;
  const int number = seeds.empty() ? 0 : static_cast<int>(seeds.front());
  if (parametersToJson(params) != parametersToJson(parametersOf(number)))
    throw std::runtime_error("the parameters are those of two edits");
  return number;
}

SavedCase documentOf(int number) {
  SavedCase document;
  document.source.hash = "0123456789abcdef";
  document.source.format = "NRRD";
  document.source.grid.size = {48, 48, 48};
  document.params = parametersOf(number);
  document.view.slabThicknessMm = number;
  return document;
}

CachedEvolve cachedOf(int number) {
  Volume<float> phi;
  phi.geometry.size = {48, 48, 48};
  for (std::size_t i = 0; i < phi.geometry.voxelCount(); ++i)
    phi.voxels.push_back(static_cast<float>(number) + static_cast<float>(i % 997) / 1024.0F);
  CachedEvolve cached;
  cached.result.phi = std::make_shared<const Volume<float>>(std::move(phi));
  cached.result.iterations = number;
  cached.report.key = std::to_string(number);
  return cached;
}

/// Any result that the cache gives is the one of its key.
void checkCache(const fs::path& folder, int newest) {
  for (int number = std::max(newest - kOldest, 0); number <= newest; ++number) {
    const auto cached = readCache(folder, std::to_string(number));
    if (!cached) continue;
    const CachedEvolve wanted = cachedOf(number);
    if (cached->result.iterations != number ||
        cached->result.phi->voxels != wanted.result.phi->voxels)
      throw std::runtime_error("the cache holds another result than it says");
  }
}

struct Opened {
  SavedCase document = documentOf(0);
  std::shared_ptr<CasePlace> place;
  int number = 0;  ///< of the last edit
};

Opened openPlace(std::shared_ptr<CasePlace> place) {
  Opened opened;
  CaseReading reading = readCase(place->folder);
  if (!reading.warnings.empty()) throw std::runtime_error(reading.warnings.front());
  opened.document = std::move(reading.document);
  opened.number = numberOf(opened.document.params);
  if (opened.document.view.slabThicknessMm != opened.number)
    throw std::runtime_error("view and parameters are of two saves");
  checkCache(place->folder, opened.number);
  int last = 0;
  for (const JournalStep& step : readJournal(place->folder, opened.document.saves)) {
    const int number = numberOf(step.params);
    if (last != 0 ? number != last + 1 : number <= opened.number)
      throw std::runtime_error("the journal's edits are not one after the other");
    last = number;
  }
  opened.number = std::max(opened.number, last);
  opened.place = std::move(place);
  return opened;
}

/// As the desktop at its start, where the user wants the edits back.
Opened openCase(const Places& places) {
  std::vector<Recovery> recoveries = findRecoveries(places.recoveries);
  if (recoveries.size() > 1) throw std::runtime_error("there are two recoveries of one case");
  Opened recovered;
  if (!recoveries.empty()) recovered = openPlace(recoveries.front().place);
  if (!isCase(places.folder)) return recovered;
  auto place = std::make_shared<CasePlace>();
  place->folder = places.folder;
  if (lockPlace(*place) != LockEnd::Locked) throw std::runtime_error("the case is locked");
  Opened opened = openPlace(std::move(place));
  if (!recovered.place) return opened;
  // Between the first save and the end of the recovery.
  if (recovered.number > opened.number)
    throw std::runtime_error("the recovery holds more than the case that was made of it");
  removeRecovery(*recovered.place);
  return opened;
}

void say(const char* what, int number) {
  std::printf("%s %d\n", what, number);
  std::fflush(stdout);
}

/// Edits in the order of the calls, the cache beside them, as in the desktop.
JobRunnerFactory runners() {
  return [first = true]() mutable {
    return std::exchange(first, false) ? makeInlineJobRunner() : makeThreadedJobRunner();
  };
}

void checkOutcomes(CaseStore& store) {
  for (const CaseStore::Outcome& outcome : store.poll())
    if (outcome.kind != CaseStore::Outcome::Kind::Saved) throw std::runtime_error(outcome.error);
}

void note(CaseStore& store, int number) {
  say("begin", number);
  store.note({0, number, "change levelset.maxIterations", parametersOf(number)});
  checkOutcomes(store);
  say("noted", number);
}

void save(CaseStore& store, const Places& places, int number) {
  store.save(places.folder, documentOf(number));
  checkOutcomes(store);
  say("saved", number);
  store.cache(cachedOf(number));
  checkOutcomes(store);
}

/// Until it is killed.
[[noreturn]] void edit(const Places& places, unsigned seed) {
  std::mt19937 random(seed);
  for (;;) {
    Opened opened = openCase(places);
    int number = opened.number;
    say("opened", number);
    CaseStore store(runners(), places.recoveries);
    store.begin(std::move(opened.document), std::move(opened.place));
    for (unsigned saves = 1 + random() % 3; saves > 0; --saves) {
      for (unsigned edits = 1 + random() % (random() % 4 == 0 ? 200 : 8); edits > 0; --edits)
        note(store, ++number);
      save(store, places, number);
    }
    if (random() % 2 == 0) store.leave();
  }
}

/// One save and a clean end.
void end(const Places& places) {
  Opened opened = openCase(places);
  CaseStore store(runners(), places.recoveries);
  store.begin(std::move(opened.document), std::move(opened.place));
  save(store, places, opened.number);
  while (store.busy()) checkOutcomes(store);
  store.leave();
}

}  // namespace
}  // namespace angiomesh::bench

int main(int argc, char** argv) {
  using namespace angiomesh;
  using namespace angiomesh::bench;
  CLI::App app("Edits a case until it is killed");
  Places places;
  std::string what;
  unsigned seed = 1;
  app.add_option("WHAT", what, "edit, state or end")
      ->required()
      ->check(CLI::IsMember({"edit", "state", "end"}));
  app.add_option("CASE", places.folder, "NAME.angiomesh")->required();
  app.add_option("RECOVERIES", places.recoveries, "Folder of the cases never saved")->required();
  app.add_option("--seed", seed, "Of the random numbers of edits and saves");
  return runProgram(app, argc, argv, [&] {
    if (what == "edit") edit(places, seed);
    if (what == "state") say("holds", openCase(places).number);
    if (what == "end") end(places);
    return 0;
  });
}
