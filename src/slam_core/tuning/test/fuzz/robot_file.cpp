// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/common/yaml_file.hpp"
#include "slam_core/tuning/robot_file_text.hpp"

namespace slam {
namespace {

bool isYaml(const std::string& text) {
  try {
    parseYaml(text, YamlLimits::configuration());
    return true;
  } catch (const YAML::Exception&) {
    return false;
  }
}

}  // namespace
}  // namespace slam

/// A robot file that tuned values are put into: its layout is refused with a sentence, or what
/// comes out is YAML with these values.
SLAM_FUZZ_TARGET(robot_file) {
  using namespace slam;
  const auto text = test::contentOf(bytes, size);
  if (!isYaml(text)) return;
  std::vector<tuning::TunedParameter> parameters(2);
  parameters[0].section = "landmark_sensor";
  parameters[0].key = "sigma_range";
  parameters[0].value = 0.05;
  parameters[1].section = "wheel_odometry";
  parameters[1].key = "alpha";
  parameters[1].value = 0.125;
  try {
    const auto remark = tuning::tuningRemark("ekf_wheel", "a.bag");
    const auto tuned =
        parseYaml(tuning::withTunedValues(text, parameters, remark), YamlLimits::configuration());
    test::requireThat(tuned["wheel_odometry"]["alpha"].as<double>() == 0.125, "another value");
  } catch (const ConfigError& refused) {
    test::requireSentence(refused);
  }
}
