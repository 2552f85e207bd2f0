// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/archive.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "slam_core/common/random.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/time.hpp"

namespace slam {
namespace {

enum class Colour { kRed, kBlue };

struct Leaf {
  int number = 0;
  std::string text;

  template <class Archive>
  void persist(Archive& archive) {
    archive(number, text);
  }
};

/// A class that is made with what its configuration says.
struct Bounded {
  explicit Bounded(int limit) : most(limit) {}
  int most;  ///< is configured
  int value = 0;

  template <class Archive>
  void persist(Archive& archive) {
    archive(value);
  }
};

struct Everything {
  bool flag = false;
  std::int8_t small = 0;
  std::uint64_t large = 0;
  double number = 0.0;
  float single = 0.0f;
  Colour colour = Colour::kRed;
  Stamp stamp;
  Duration duration{};
  std::string text;
  std::optional<Leaf> leaf, no_leaf;
  std::unique_ptr<Leaf> pointer, null;
  std::vector<Leaf> list;
  std::vector<double> numbers;
  std::vector<bool> flags;
  std::deque<int> queue;
  std::array<std::optional<int>, 3> array;
  std::map<int, std::string> map;
  std::set<std::pair<int, int>> set;
  std::unordered_map<std::int64_t, Leaf> table;
  std::unordered_set<std::int64_t> known;
  Eigen::Matrix3d fixed = Eigen::Matrix3d::Zero();
  Eigen::MatrixXd free;
  Eigen::Array<bool, 3, 1> which = Eigen::Array<bool, 3, 1>::Constant(false);
  Eigen::Matrix<float, Eigen::Dynamic, 1, Eigen::ColMajor, 9, 1> few;
  std::vector<Bounded> bounded;

  template <class Archive>
  void persist(Archive& archive) {
    archive(flag, small, large, number, single, colour, stamp, duration, text, leaf, no_leaf,
            pointer, null, list, numbers, flags, queue, array, map, set, table, known, fixed, free,
            which, few);
    archive.list(bounded, [] { return Bounded(9); });
  }
};

Everything something() {
  Everything it;
  it.flag = true;
  it.small = -7;
  it.large = ~std::uint64_t{0};
  it.number = -0.0;
  it.single = std::numeric_limits<float>::denorm_min();
  it.colour = Colour::kBlue;
  it.stamp = stampFromNanoseconds(-5);
  it.duration = std::chrono::seconds(3);
  it.text = std::string("a\0b", 3);
  it.leaf = Leaf{3, "three"};
  it.pointer = std::make_unique<Leaf>(Leaf{4, "four"});
  it.list = {{1, "one"}, {2, ""}};
  it.numbers = {std::nan(""), -INFINITY, 1.0 / 3.0};
  it.flags = {true, false, true};
  it.queue = {1, 2, 3};
  it.array[1] = 8;
  it.map = {{1, "one"}};
  it.set = {{1, 2}, {-1, 4}};
  for (int i = 0; i < 50; ++i) {
    it.table[(i * 7919) % 50 - 25] = {i, "leaf"};
    it.known.insert((i * 7919) % 50);
  }
  it.fixed(1, 2) = 4.0;
  it.free = Eigen::MatrixXd::Constant(2, 3, 0.1);
  it.which(2) = true;
  it.few = decltype(it.few)::Constant(4, 0.5f);
  it.bounded = {Bounded(1)};
  it.bounded[0].value = 6;
  return it;
}

template <class T>
std::string written(const T& value) {
  ArchiveWriter archive;
  archive(value);
  return archive.take();
}

template <class T>
void read(const std::string& bytes, T& value) {
  ArchiveReader archive(bytes);
  archive(value);
  EXPECT_EQ(archive.left(), 0u);
}

TEST(Archive, GivesBackEachBit) {
  const auto bytes = written(something());
  Everything it;
  it.no_leaf = Leaf();
  it.null = std::make_unique<Leaf>();
  read(bytes, it);
  EXPECT_EQ(written(it), bytes);
  EXPECT_TRUE(std::signbit(it.number));
  EXPECT_TRUE(std::isnan(it.numbers[0]));
  EXPECT_FALSE(it.no_leaf || it.null);
  EXPECT_EQ(it.table.at(-25).text, "leaf");
  EXPECT_EQ(it.set.count({-1, 4}), 1u);
  EXPECT_EQ(it.bounded[0].most, 9) << "as it is configured here";
  EXPECT_EQ(it.bounded[0].value, 6);
}

TEST(Archive, DoesNotDependOnTheOrderOfAHashTable) {
  Everything forth, back;
  for (int i = 0; i < 1000; ++i) forth.known.insert(i);
  for (int i = 1000; i-- > 0;) back.known.insert(i);
  EXPECT_EQ(written(forth), written(back));
}

struct Sharing {
  std::shared_ptr<const Leaf> first, second, none;
  std::vector<std::shared_ptr<Leaf>> more;

  template <class Archive>
  void persist(Archive& archive) {
    archive(first, second, none, more);
  }
};

TEST(Archive, SharesWhatWasShared) {
  Sharing it;
  const auto leaf = std::make_shared<Leaf>(Leaf{1, "one"});
  it.first = it.second = leaf;
  it.more = {leaf, std::make_shared<Leaf>(), leaf};
  Sharing back;
  read(written(it), back);
  EXPECT_EQ(back.first->text, "one");
  EXPECT_EQ(back.first, back.second);
  EXPECT_EQ(back.first, back.more[2]);
  EXPECT_NE(back.first, back.more[1]);
  EXPECT_EQ(back.none, nullptr);
  EXPECT_EQ(back.first.use_count(), 4) << "the archive does not hold on to it";
}

TEST(Archive, RefusesWhatIsCutAnywhere) {
  const auto bytes = written(something());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto sentence = test::sentenceOf([&] {
      Everything it;
      ArchiveReader archive(bytes.data(), size);
      archive(it);
    });
    EXPECT_TRUE(test::oneSays({sentence}, {"it ", "save it again"})) << size;
  }
}

/// Damaged numbers of elements, sizes and references must neither crash nor take memory.
TEST(Archive, SurvivesAnyDamage) {
  const auto bytes = written(something());
  RandomStream random(3, 0);
  for (int trial = 0; trial < 20000; ++trial) {
    auto damaged = bytes;
    for (int i = 0; i < 3; ++i)
      damaged[static_cast<std::size_t>(random.uniform() * double(bytes.size()))] =
          static_cast<char>(random.uniform() * 256);
    Everything it;
    Sharing sharing;
    for (int i = 0; i < 2; ++i)
      test::sentenceOf([&] {
        ArchiveReader archive(damaged);
        i == 0 ? archive(it) : archive(sharing);
      });
  }
}

TEST(Archive, RefusesAReferenceToAnotherKindOfObject) {
  const std::shared_ptr<Leaf> leaf = std::make_shared<Leaf>();
  ArchiveWriter writer;
  writer(leaf, std::uint64_t{1});
  const auto bytes = writer.take();
  ArchiveReader archive(bytes);
  std::shared_ptr<Leaf> same;
  std::shared_ptr<Everything> other;
  archive(same);
  EXPECT_THROW(archive(other), std::runtime_error);
}

}  // namespace
}  // namespace slam
