// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/transport/sweep/lagged_faces.h"

#include <algorithm>

namespace etendue {
namespace {

FaceCode upwind_of(const SweepOrder& order, OrdinateIndex m, std::size_t lagged) {
  return m.at() % 2 == 0 ? order.lagged[lagged].upwind : order.lagged[lagged].downwind;
}

/// First number of a lagged face of ordinate m in the lagged part of a state.
std::size_t first_of(const Discretization& d, OrdinateIndex m, std::size_t lagged) {
  return (2 * (d.orders->lagged_start(m.value() / 2) + lagged) + m.at() % 2) * d.cells.trace_length();
}

}  // namespace

template <class Real>
void set_lagged(const Discretization& d, OrdinateIndex m, const SweepOrder& order, const TransportState& last,
                const SweepSlotsOf<Real>& slots) {
  const auto stride = static_cast<std::size_t>(d.cells.stride());
  for (std::size_t i = 0; i < order.lagged.size(); ++i) {
    const FaceCode upwind = upwind_of(order, m, i);
    const double* value = last.lagged().data() + first_of(d, m, i);
    for (std::size_t at = 0; at < d.cells.trace_length(); at += stride)
      std::copy(value + at, value + at + stride, slots.face_node(upwind, at / stride));
  }
}

template <class Real>
void keep_lagged(const Discretization& d, OrdinateIndex m, const SweepOrder& order, TransportState& next,
                 const SweepSlotsOf<Real>& slots) {
  const auto stride = static_cast<std::size_t>(d.cells.stride());
  for (std::size_t i = 0; i < order.lagged.size(); ++i) {
    const FaceCode upwind = upwind_of(order, m, i);
    double* value = next.lagged().data() + first_of(d, m, i);
    for (std::size_t at = 0; at < d.cells.trace_length(); at += stride) {
      const Real* node = slots.face_node(upwind, at / stride);
      std::copy(node, node + stride, value + at);
    }
  }
}

template void set_lagged(const Discretization&, OrdinateIndex, const SweepOrder&, const TransportState&,
                         const SweepSlotsOf<double>&);
template void set_lagged(const Discretization&, OrdinateIndex, const SweepOrder&, const TransportState&,
                         const SweepSlotsOf<float>&);
template void keep_lagged(const Discretization&, OrdinateIndex, const SweepOrder&, TransportState&,
                          const SweepSlotsOf<double>&);
template void keep_lagged(const Discretization&, OrdinateIndex, const SweepOrder&, TransportState&,
                          const SweepSlotsOf<float>&);

}  // namespace etendue
