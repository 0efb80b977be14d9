// SPDX-License-Identifier: Apache-2.0
#include "harness/cli/against_all.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "harness/cli/everything_run.h"
#include "harness/cli/planned.h"
#include "harness/cli/run_line.h"
#include "harness/record/kept_certificate.h"
#include "reports/reports.h"

namespace lamina {
namespace {

// One backend. Returns how many messages the API's checker had.
size_t run_both_frames(const ProbedBackend& probed, const Library& library, const Scene& scene, const Plan& plan,
                       const CompareOptions& options, RecordWriter& record) {
  const std::unique_ptr<Backend> backend = open_backend(probed.name, {options.device, options.validation});
  Progress progress(probed.name);
  std::optional<RoundOptions> rounds;
  if (options.times) {
    progress.show(0, "certifying the timer");
    const TimerRow timer = certified_timer(*backend, library.shaders, options.cache);
    record.append(to_json(timer));
    if (timer.ok) rounds = options.rounds;
  }
  ShaderCache shaders(backend->info().api, library.shaders);
  for (const SavingRow& row : saving_rows(*backend, library, scene, plan, shaders, options, rounds, progress.tell()))
    record.append(to_json(row));
  const std::vector<std::string> messages = backend->take_messages();
  for (const std::string& message : messages) fmt::print(stderr, "lamina: {}: {}\n", probed.name, message);
  return messages.size();
}

SavingRow failed_row(const ProbedBackend& backend, const Scene& scene, const std::string& reason) {
  SavingRow row;
  row.scene = scene.name, row.backend = backend.name, row.view = scene.views.front().name, row.failure = reason;
  return row;
}

}  // namespace

int run_against_all(const CompareOptions& options) {
  pin_rasterizer_threads();
  const Library library = load_library_for(options.scene);
  const Scene scene = load_scene_for(options.scene, library);
  const Plan plan = plan_for(options.scene, library, scene, options.aspect());
  const std::vector<ProbedBackend> backends = usable_backends(options);
  ShaderCache shaders(Api::vulkan, library.shaders);
  const PlanRow planned = plan_row(plan, scene, shaders, options);

  RecordWriter record =
      begin_record("compare", options.out, run_line(options, options.rounds, options.quick, scene, backends), planned);
  size_t messages = 0;
  for (const ProbedBackend& backend : backends) {
    std::string failure = backend.failure;
    try {
      if (failure.empty()) messages += run_both_frames(backend, library, scene, plan, options, record);
    } catch (const Error& error) {
      if (error.stage() == "record" || error.kind() == ErrorKind::bad_input) throw;
      failure = error.what();
    }
    if (!failure.empty()) record.append(to_json(failed_row(backend, scene, failure)));
  }

  write_reports(options.out);
  const Record written = read_record(options.out / "record.jsonl");
  fmt::print("{}\nreport: {}\n", terminal_table(written, ::isatty(STDOUT_FILENO) == 1), (options.out / "index.html").string());
  const bool well = std::ranges::all_of(written.savings,
                                        [](const SavingRow& row) { return row.failure.empty() && row.different_pixels == 0; });
  return well && messages == 0 && std::ranges::all_of(written.timers, &TimerRow::ok) ? 0 : 1;
}

}  // namespace lamina
