// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/yaml_file.hpp"

#include <yaml-cpp/eventhandler.h>

#include <map>
#include <sstream>
#include <vector>

#include "slam_core/common/input_file.hpp"

namespace slam {
namespace {

/// Listens to the parser and counts; nothing is kept of the content.
class LimitGuard final : public YAML::EventHandler {
 public:
  explicit LimitGuard(const YamlLimits& limits) : limits_(limits) {}

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { addLeaf(mark, anchor); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string&) override {
    addLeaf(mark, anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto size = sizes_.find(anchor);
    if (size == sizes_.end())
      throw YAML::ParserException(mark, "an alias stands within what it refers to");
    add(mark, size->second);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  struct OpenNode {
    YAML::anchor_t anchor;
    std::uint64_t nodes_before;
  };

  void add(const YAML::Mark& mark, std::uint64_t nodes) {
    nodes_ += nodes;
    if (nodes_ > limits_.nodes)
      throw YAML::ParserException(mark, "it holds more than " + std::to_string(limits_.nodes) +
                                            " values, each alias counted as what it stands for");
  }

  void addLeaf(const YAML::Mark& mark, YAML::anchor_t anchor) {
    add(mark, 1);
    if (anchor != YAML::NullAnchor) sizes_[anchor] = 1;
  }

  void open(const YAML::Mark& mark, YAML::anchor_t anchor) {
    open_.push_back({anchor, nodes_});
    add(mark, 1);
    if (open_.size() > limits_.depth)
      throw YAML::ParserException(
          mark, "lists and maps are nested more than " + std::to_string(limits_.depth) + " deep");
  }

  void close() {
    const auto node = open_.back();
    open_.pop_back();
    if (node.anchor != YAML::NullAnchor) sizes_[node.anchor] = nodes_ - node.nodes_before;
  }

  YamlLimits limits_;
  std::uint64_t nodes_ = 0;
  std::vector<OpenNode> open_;
  std::map<YAML::anchor_t, std::uint64_t> sizes_;  // of nodes that are closed
};

void requireWithin(const std::string& text, const YamlLimits& limits) {
  std::istringstream stream(text);
  LimitGuard guard(limits);
  YAML::Parser(stream).HandleNextDocument(guard);
}

/// Counting takes as long as reading does, which is some seconds for a large map. Without an alias
/// there are no more values than characters; for the depth of so much text the parser's own bound
/// will do.
bool isLargeAndPlain(const std::string& text, const YamlLimits& limits) {
  return text.size() > YamlLimits::configuration().bytes && text.size() <= limits.nodes &&
         text.find('*') == std::string::npos;
}

}  // namespace

YAML::Node parseYaml(const std::string& text, const YamlLimits& limits) {
  if (!isLargeAndPlain(text, limits)) requireWithin(text, limits);
  return YAML::Load(text);
}

YAML::Node loadYamlFile(const std::string& path, const std::string& what,
                        const YamlLimits& limits) {
  return parseYaml(readInputFile(path, what, limits.bytes), limits);
}

}  // namespace slam
