// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <deque>
#include <span>

#include "solver/transport/state/aligned_array.h"
#include "solver/transport/sweep/sweep_pass.h"

namespace etendue {

/// All that a sweep sums over its ordinates: parts of the next state and of the record.
struct SummedArrays {
  std::span<double> fluence, moments, irradiance;
  std::span<double> net_flux, exitance, meters, source_products, absorbed;  ///< empty without a record

  static SummedArrays of(const SweepPass& pass) {
    SummedArrays all{pass.next.fluence(), pass.next.moments(), pass.next.irradiance(), {}, {}, {}, {}, {}};
    if (pass.record == nullptr) return all;
    all.net_flux = pass.record->net_flux.span();
    all.exitance = pass.record->exitance.span();
    all.meters = pass.record->meters;
    all.source_products = pass.record->source_products;
    all.absorbed = pass.record->absorbed;
    return all;
  }

  std::array<std::span<double>, 8> list() const {
    return {fluence, moments, irradiance, net_flux, exitance, meters, source_products, absorbed};
  }
};

/// Arrays for the sums of one section that waits for others (BatchSections).
class SectionSums {
 public:
  /// Arrays of the sizes of those of a sweep; moments only where `with_moments`.
  SummedArrays arrays(const SummedArrays& like, bool with_moments) {
    const auto fitted = [](AlignedArray& array, std::size_t size) {
      if (array.size() < size) array = AlignedArray(size);
      return array.span().first(size);
    };
    return {fitted(fluence_, like.fluence.size()),
            fitted(moments_, with_moments ? like.moments.size() : 0),
            fitted(irradiance_, like.irradiance.size()),
            fitted(net_flux_, like.net_flux.size()),
            fitted(exitance_, like.exitance.size()),
            fitted(meters_, like.meters.size()),
            fitted(source_products_, like.source_products.size()),
            fitted(absorbed_, like.absorbed.size())};
  }
  /// Gives back what only a record needs.
  void end_record() { net_flux_ = exitance_ = meters_ = source_products_ = absorbed_ = AlignedArray(); }

 private:
  AlignedArray fluence_, moments_, irradiance_, net_flux_, exitance_, meters_, source_products_, absorbed_;
};

/// Arrays for all sections that wait. Sweeps that take turns share them.
using WaitingSections = std::deque<SectionSums>;

}  // namespace etendue
