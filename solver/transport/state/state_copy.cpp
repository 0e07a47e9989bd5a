// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/state/state_copy.h"

#include <algorithm>
#include <span>

#include "base/errors.h"
#include "solver/transport/kernel/sweep_kernel.h"

namespace etendue {
namespace {

std::vector<double> unpadded_rows(std::span<const double> values, std::size_t bands, std::size_t stride) {
  std::vector<double> result;
  result.reserve(values.size() / stride * bands);
  for (std::size_t row = 0; row < values.size(); row += stride)
    result.insert(result.end(), &values[row], &values[row] + bands);
  return result;
}

bool fits(const std::vector<double>& from, std::size_t bands, std::size_t stride, std::span<double> values) {
  return from.size() == values.size() / stride * bands;
}

void pad(const std::vector<double>& from, std::size_t bands, std::size_t stride, std::span<double> values) {
  if (!fits(from, bands, stride, values))
    throw InputError(
        "the state to start from is not of this kind (other elements, directions, scattering or mirrors)");
  for (std::size_t row = 0; row * bands < from.size(); ++row)
    std::copy(&from[row * bands], &from[row * bands] + bands, &values[row * stride]);
}

}  // namespace

SavedState saved(const TransportState& state, int bands) {
  const auto count = static_cast<std::size_t>(bands);
  const auto stride = static_cast<std::size_t>(lane_stride(bands));
  return {bands,
          unpadded_rows(state.fluence(), count, stride),
          unpadded_rows(state.moments(), count, stride),
          unpadded_rows(state.irradiance(), count, stride),
          unpadded_rows(state.mirrors(), count, stride),
          unpadded_rows(state.lagged(), count, stride),
          unpadded_rows(state.radiance(), count, stride)};
}

void restore(const SavedState& from, int bands, TransportState& state) {
  if (from.bands != bands) throw InputError("the state to start from has another number of bands");
  const auto count = static_cast<std::size_t>(bands);
  const auto stride = static_cast<std::size_t>(lane_stride(bands));
  pad(from.fluence, count, stride, state.fluence());
  pad(from.moments, count, stride, state.moments());
  pad(from.irradiance, count, stride, state.irradiance());
  const auto pad_by_ordinate = [&](const std::vector<double>& values, std::span<double> into) {
    if (!from.is_turned || fits(values, count, stride, into)) pad(values, count, stride, into);
  };
  pad_by_ordinate(from.mirrors, state.mirrors());
  pad_by_ordinate(from.lagged, state.lagged());
  pad_by_ordinate(from.radiance, state.radiance());
}

}  // namespace etendue
