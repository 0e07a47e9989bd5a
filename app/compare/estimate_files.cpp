// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/compare/estimate_files.h"

#include "app/write/json/summary.h"
#include "app/write/result/output_folder.h"

namespace etendue {

void write_estimate(const ErrorEstimate& estimate, const std::filesystem::path& directory) {
  double seconds = 0;
  for (const ErrorPart& part : estimate.parts) seconds += part.seconds;
  OutputFolder folder(directory);
  folder.lock();
  if (holds_other_run(directory)) return;  // its numbers are others
  folder.add_text("estimate.csv", estimate_csv(estimate));
  folder.add_text("summary.json", summary_with_estimate(directory, estimate_json(estimate), seconds));
  folder.publish({});
}

}  // namespace etendue
