// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/write/result/fingerprint.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "solver/materials/media/sampled_field.h"

namespace etendue::fingerprint_test {
namespace {

Case with_text(const std::string& resolved) {
  Case input;
  input.resolved_toml = resolved;
  return input;
}

std::vector<std::string> different(const Case& a, const Case& b) {
  return different_parts(case_parts(a), case_parts(b));
}

// A unit of photometry changes what is written; the lumens of a lamp change the answer.
TEST(Fingerprint, TellsLumensOfLightsFromUnits) {
  EXPECT_TRUE(different(with_text("[units]\nluminous_flux = \"lm\"\n"),
                        with_text("[units]\nluminous_flux = \"klm\"\n"))
                  .empty());
  EXPECT_EQ(
      different(with_text("[[light]]\nluminous_flux = 800\n"), with_text("[[light]]\nluminous_flux = 900\n")),
      std::vector<std::string>{"light"});
}

Case with_field(double value) {
  FieldData data;
  data.image = ImageGrid{};
  data.values = {value};
  Case input =
      with_text("[media.gas]\nabsorption = { file = \"gas.vti\" }\n[[light]]\ndistribution = \"lamp.ies\"\n");
  const auto field = std::make_shared<SampledField>("gas.vti", std::move(data), std::nullopt);
  input.media["gas"].absorption = BandValues{{Formula("f(x,y,z)", {{"f", field}})}, {}};
  input.lights.resize(1);
  return input;
}

TEST(Fingerprint, CoversTheNumbersInFiles) {
  EXPECT_TRUE(different(with_field(2), with_field(2)).empty());
  EXPECT_EQ(different(with_field(2), with_field(3)), std::vector<std::string>{"media"});
  Case other_lamp = with_field(2);
  other_lamp.lights[0].intensity = {1, 0.5};
  EXPECT_EQ(different(with_field(2), other_lamp), std::vector<std::string>{"light"});
}

// The text of a case names the gases, and their coefficients lie elsewhere.
TEST(Fingerprint, CoversTheCoefficientsOfGases) {
  const auto with_weight = [](double weight) {
    Case input = with_text("[bands]\nwsgg = \"bordbar\"\n");
    input.bands.gas.gases = {{0.0, TemperatureCurve::Polynomial{{1 - weight}, 300, 2400}},
                             {1.0, TemperatureCurve::Polynomial{{weight}, 300, 2400}}};
    return input;
  };
  EXPECT_TRUE(different(with_weight(0.2), with_weight(0.2)).empty());
  EXPECT_EQ(different(with_weight(0.2), with_weight(0.3)), std::vector<std::string>{"bands"});
  const auto with_ratio = [](double ratio) {
    Case input = with_text("[bands]\nmolar_ratio = { file = \"gas.vti\" }\n");
    input.molar_ratio = with_field(ratio).media["gas"].absorption;
    return input;
  };
  EXPECT_TRUE(different(with_ratio(2), with_ratio(2)).empty());
  EXPECT_EQ(different(with_ratio(2), with_ratio(3)), std::vector<std::string>{"bands"});
}

}  // namespace
}  // namespace etendue::fingerprint_test
