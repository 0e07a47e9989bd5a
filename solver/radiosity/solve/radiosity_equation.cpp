// SPDX-License-Identifier: AGPL-3.0-or-later
#include "solver/radiosity/solve/radiosity_equation.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace etendue {
namespace {

double patch_area(const RadiosityEquation& equation, std::size_t patch) {
  return equation.exchange.patches()[patch].area();
}

/// [band] sum of A x over the patches.
std::vector<double> powers(const RadiosityEquation& equation, const std::vector<double>& x) {
  std::vector<double> sum(equation.bands, 0);
  for (std::size_t i = 0; i < x.size(); ++i)
    sum[i % equation.bands] += patch_area(equation, i / equation.bands) * x[i];
  return sum;
}

/// Of what has arrived, from all that was sent: what is emitted and sent on, but for what is still unsent.
void note_redirected(const RadiosityEquation& equation, const std::vector<double>& unsent,
                     RadiosityState& state) {
  if (equation.extended == nullptr) return;
  std::vector<double> sent = equation.sent_on(state.irradiance), arrived = state.irradiance;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    sent[i] += equation.emission[i] - (unsent.empty() ? 0 : unsent[i]);
    arrived[i] *= patch_area(equation, i / equation.bands);
  }
  state.redirected = equation.redirected(sent, arrived);
}

/// What is still to arrive: the reflected part of each arrival again, in the ratio of the last pass.
double still_to_come(double exitant, double reflected) {
  if (reflected <= 0) return 0;
  const double ratio = std::min(reflected / exitant, 1 - 1e-12);
  return reflected / (1 - ratio);
}

}  // namespace

std::vector<double> RadiosityEquation::sent_on(const std::vector<double>& irradiance) const {
  std::vector<double> sent(irradiance.size());
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = reflectance[i] * irradiance[i];
  for (const SheetPassage& passage : passages)
    for (std::size_t b = 0; b < bands; ++b)
      sent[passage.to * bands + b] +=
          transmittance[passage.to * bands + b] * passage.share * irradiance[passage.from * bands + b];
  return sent;
}

std::vector<double> RadiosityEquation::arriving(const std::vector<double>& x) const {
  return extended != nullptr ? extended->times(x) : exchange.times(x, bands);
}

std::vector<double> RadiosityEquation::row(std::size_t j) const {
  if (extended != nullptr) return extended->row(j);
  const std::vector<double> areas = exchange.row(j);
  std::vector<double> result(areas.size() * bands);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = areas[i / bands];
  return result;
}

std::vector<double> RadiosityEquation::redirected(const std::vector<double>& x,
                                                  const std::vector<double>& arriving) const {
  if (extended == nullptr) return std::vector<double>(x.size(), 0);
  std::vector<double> result = extended->redirected(x, arriving);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] /= exchange.patches()[i / bands].area();
  return result;
}

RadiosityState solve_directly(const RadiosityEquation& equation) {
  const std::size_t n = equation.exchange.size();
  const auto size = static_cast<Eigen::Index>(n);
  RadiosityState state;
  state.irradiance.assign(n * equation.bands, 0);
  for (std::size_t b = 0; b < equation.bands; ++b) {
    // (A - G (rho + tau P)) H = G E
    Eigen::MatrixXd matrix(size, size);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    for (std::size_t j = 0; j < n; ++j) {
      const auto row = static_cast<Eigen::Index>(j);
      const std::vector<double> areas = equation.row(j);
      for (std::size_t k = 0; k < n; ++k) {
        const double g = areas[k * equation.bands + b];
        right[row] += g * equation.emission[k * equation.bands + b];
        matrix(row, static_cast<Eigen::Index>(k)) = -g * equation.reflectance[k * equation.bands + b];
      }
      matrix(row, row) += patch_area(equation, j);
      for (const SheetPassage& passage : equation.passages)
        matrix(row, static_cast<Eigen::Index>(passage.from)) -=
            areas[passage.to * equation.bands + b] * passage.share *
            equation.transmittance[passage.to * equation.bands + b];
    }
    const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
    for (std::size_t j = 0; j < n; ++j)
      state.irradiance[j * equation.bands + b] = solution[static_cast<Eigen::Index>(j)];
  }
  state.residual.assign(equation.bands, 0);
  state.converged = true;
  note_redirected(equation, {}, state);
  return state;
}

RadiosityState solve_by_gathering(const RadiosityEquation& equation, const RadiosityLimits& limits,
                                  const RadiosityObserver& observer) {
  const std::size_t bands = equation.bands;
  RadiosityState state;
  state.irradiance.assign(equation.emission.size(), 0);
  state.residual.assign(bands, 1);
  std::vector<double> sent = equation.emission, arrived(bands, 0);
  while (!state.converged && state.passes < limits.most_passes) {
    ++state.passes;
    std::vector<double> incident = equation.arriving(sent);
    const std::vector<double> exitant = powers(equation, sent),
                              redirected = powers(equation, equation.redirected(sent, incident));
    for (std::size_t i = 0; i < incident.size(); ++i) {
      incident[i] /= patch_area(equation, i / bands);
      state.irradiance[i] += incident[i];
    }
    sent = equation.sent_on(incident);
    const std::vector<double> in = powers(equation, incident), reflected = powers(equation, sent);
    state.converged = true;
    for (std::size_t b = 0; b < bands; ++b) {
      state.bounces.push_back(
          {state.passes, b, exitant[b], in[b], redirected[b], in[b] - redirected[b] - reflected[b]});
      arrived[b] += in[b];
      state.residual[b] = arrived[b] > 0 ? still_to_come(exitant[b], reflected[b]) / arrived[b] : 0;
      state.converged = state.converged && state.residual[b] <= limits.tolerance;
    }
    if (!observer) continue;
    note_redirected(equation, sent, state);
    if (!observer(state)) break;
  }
  note_redirected(equation, sent, state);
  return state;
}

RadiosityState solve_by_shooting(const RadiosityEquation& equation, const RadiosityLimits& limits,
                                 const RadiosityObserver& observer) {
  const std::size_t bands = equation.bands, n = equation.exchange.size();
  RadiosityState state;
  state.irradiance.assign(equation.emission.size(), 0);
  state.residual.assign(bands, 1);
  std::vector<double> unsent = equation.emission;
  const auto waiting = [&](std::size_t j) {
    double sum = 0;
    for (std::size_t b = 0; b < bands; ++b) sum += unsent[j * bands + b];
    return sum * patch_area(equation, j);
  };
  const auto look = [&] {
    note_redirected(equation, unsent, state);
    const std::vector<double> left = powers(equation, unsent), in = powers(equation, state.irradiance);
    for (std::size_t b = 0; b < bands; ++b)
      state.residual[b] = in[b] > 0 ? left[b] / in[b] : (left[b] > 0 ? 1 : 0);
    // What is unsent is reflected again: as often as on the mean so far.
    const std::vector<double> given = powers(equation, equation.emission);
    state.converged = true;
    for (std::size_t b = 0; b < bands; ++b) {
      if (given[b] > 0) state.residual[b] *= std::max(1.0, in[b] / given[b]);
      state.converged = state.converged && state.residual[b] <= limits.tolerance;
    }
    return !observer || observer(state);
  };
  const std::size_t between = std::max<std::size_t>(1, n / 10);
  std::vector<double> power(n);
  for (std::size_t j = 0; j < n; ++j) power[j] = waiting(j);
  for (std::size_t shot = 1; !state.converged; ++shot) {
    const auto j = static_cast<std::size_t>(std::ranges::max_element(power) - power.begin());
    const std::vector<double> row = equation.row(j);
    const std::vector<double> shot_power(unsent.begin() + static_cast<std::ptrdiff_t>(j * bands),
                                         unsent.begin() + static_cast<std::ptrdiff_t>((j + 1) * bands));
    for (std::size_t b = 0; b < bands; ++b) unsent[j * bands + b] = 0;
    for (const SheetPassage& passage : equation.passages)
      for (std::size_t b = 0; b < bands; ++b)
        unsent[passage.to * bands + b] += equation.transmittance[passage.to * bands + b] * passage.share *
                                          row[passage.from * bands + b] / patch_area(equation, passage.from) *
                                          shot_power[b];
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t b = 0; b < bands; ++b) {
        const double incident = row[k * bands + b] / patch_area(equation, k) * shot_power[b];
        state.irradiance[k * bands + b] += incident;
        unsent[k * bands + b] += equation.reflectance[k * bands + b] * incident;
      }
      power[k] = waiting(k);
    }
    power[j] = waiting(j);
    state.passes = static_cast<int>((shot + n - 1) / n);
    if (shot % between != 0 &&
        power[static_cast<std::size_t>(std::ranges::max_element(power) - power.begin())] > 0)
      continue;
    if (!look() || (state.passes >= limits.most_passes && shot % n == 0)) break;
  }
  return state;
}

}  // namespace etendue
