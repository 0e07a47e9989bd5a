// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/run/methods/photon_numbers.h"

namespace etendue {
namespace {

/// Visits every Monte Carlo estimate, in a fixed order.
template <class Numbers, class Visitor>
void visit(Numbers& numbers, Visitor&& each) {
  for (auto& wall : numbers.walls)
    for (auto& power : wall) {
      each(power.irradiance_mean);
      each(power.incoming);
      each(power.outgoing);
    }
  for (auto& wall : numbers.net)
    for (auto& net : wall) each(net);
  for (auto& region : numbers.regions)
    for (auto& power : region) {
      each(power.fluence_mean);
      each(power.absorbed);
    }
  for (auto& balance : numbers.balances) {
    each(balance.emitted);
    each(balance.inflow);
    each(balance.absorbed);
    each(balance.outflow);
    each(balance.residual);
  }
}

}  // namespace

MeasuredNumbers::MeasuredNumbers(const Problem& problem, const Solution& solution)
    : walls(wall_powers(problem, solution)),
      regions(region_powers(problem, solution)),
      balances(etendue::balances(problem, solution)) {
  for (const auto& wall : walls) {
    net.emplace_back();
    for (const WallPower& power : wall) net.back().push_back(power.incoming - power.outgoing);
  }
}

std::vector<double> MeasuredNumbers::list() const {
  std::vector<double> list;
  visit(*this, [&](double number) { list.push_back(number); });
  return list;
}

void MeasuredNumbers::assign(const std::vector<double>& list) {
  std::size_t next = 0;
  visit(*this, [&](double& number) { number = list.at(next++); });
}

}  // namespace etendue
