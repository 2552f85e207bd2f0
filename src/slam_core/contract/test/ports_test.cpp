// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/contract/ports.hpp"

#include <gtest/gtest.h>

#include "slam_core/models/laser_scan.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::test {

/// A kind of the test's own.
struct Echo {
  Stamp stamp;
  std::uint64_t sequence = 0;
  double range = 1.0;
};

std::string faultOf(const Echo& echo) { return echo.range > 0.0 ? "" : "an echo without range"; }

/// A kind whose source does not count.
struct Knock {
  Stamp stamp;
};

/// A kind that orders nothing.
struct Colour {
  std::string name;
};

namespace {

Stamp at(int second) { return Stamp(std::chrono::seconds(second)); }

/// Takes and makes something of each.
struct Listener {
  void set(const Echo& echo) { heard = echo.range; }
  void set(const Colour& value) { colour = value; }

  double heard = 0.0;
  std::optional<Colour> colour;
  std::optional<Echo> louder;
};

TEST(Kind, HasTheNameOfItsType) {
  EXPECT_EQ(nameOf(kindOf<Motion>()), "slam::Motion");
  EXPECT_EQ(nameOf(kindOf<Echo>()), "slam::test::Echo");
  EXPECT_EQ(nameOf(kindOf<int>()), "int");
  EXPECT_NE(kindOf<Echo>(), kindOf<Knock>());
}

TEST(Datum, GivesItsValueOnlyAsTheKindItIs) {
  const Colour red{"red"};
  const auto datum = Datum::of(red);
  EXPECT_EQ(datum.kind(), kindOf<Colour>());
  EXPECT_EQ(datum.as<Colour>(), &red);
  EXPECT_EQ(datum.as<Echo>(), nullptr);
}

TEST(KindTraits, HoldACopyWithItsStampAndSequence) {
  const auto traits = KindTraits::of<Echo>();
  ASSERT_NE(traits.hold, nullptr);
  Echo echo{at(3), 7, 2.5};
  const auto held = traits.hold(&echo);
  echo.range = 9.0;
  EXPECT_EQ(held.stamp, at(3));
  EXPECT_EQ(held.sequence, 7u);
  EXPECT_EQ(static_cast<const Echo*>(held.value.get())->range, 2.5);
}

TEST(KindTraits, WithoutASequenceItIsNought) {
  const Knock knock{at(4)};
  const auto held = KindTraits::of<Knock>().hold(&knock);
  EXPECT_EQ(held.stamp, at(4));
  EXPECT_EQ(held.sequence, 0u);
}

TEST(KindTraits, AKindWithoutAStampCannotBeHeld) {
  EXPECT_EQ(KindTraits::of<Colour>().hold, nullptr);
  EXPECT_EQ(KindTraits::of<Motion>().hold, nullptr) << "it has an interval";
  EXPECT_NE(KindTraits::of<LaserScan>().hold, nullptr);
}

TEST(KindTraits, TellTheFaultThatTheKindTells) {
  const Echo good{at(1), 0, 1.0}, bad{at(1), 0, -1.0};
  EXPECT_EQ(KindTraits::of<Echo>().fault_of(&good), "");
  EXPECT_EQ(KindTraits::of<Echo>().fault_of(&bad), "an echo without range");
  const Knock knock;
  EXPECT_EQ(KindTraits::of<Knock>().fault_of(&knock), "") << "a kind that tells none";
}

TEST(Ports, AnInputTriggersAndIsMandatoryUnlessItSaysOtherwise) {
  Listener listener;
  Ports ports;
  const auto& plain = ports.takes<Echo>("sonar", "echoes", &listener);
  EXPECT_EQ(plain.name, "sonar");
  EXPECT_EQ(plain.kind, kindOf<Echo>());
  EXPECT_EQ(plain.sentence, "echoes");
  EXPECT_EQ(plain.time, TimeRole::kTrigger);
  EXPECT_TRUE(plain.is_mandatory);
  EXPECT_FALSE(ports.takes<Echo>("sonar_2", "echoes", &listener).optional().is_mandatory);
  const auto carrier = ports.takes<Echo>("sonar_3", "echoes", &listener).carrier();
  EXPECT_EQ(carrier.time, TimeRole::kCarrier);
  const auto latched = ports.takes<Colour>("paint", "its colour", &listener).latched().optional();
  EXPECT_EQ(latched.time, TimeRole::kLatched);
  EXPECT_FALSE(latched.is_mandatory);
  EXPECT_EQ(plain.time, TimeRole::kTrigger) << "of the others nothing has changed";
  EXPECT_EQ(ports.inputs().size(), 4u);
}

TEST(Ports, AnInputGivesTheComponentItsValue) {
  Listener listener;
  Ports ports;
  ports.takes<Echo>("sonar", "echoes", &listener);
  ports.takes<Colour>("sonar", "its colour", &listener);
  double twice = 0.0;
  ports.takes<Echo>("other", "echoes", [&](const Echo& echo) { twice = 2 * echo.range; });
  const Echo echo{at(1), 0, 4.0};
  ports.input("sonar", kindOf<Echo>())->set(&echo);
  EXPECT_EQ(listener.heard, 4.0);
  EXPECT_FALSE(listener.colour);
  ports.input("other", kindOf<Echo>())->set(&echo);
  EXPECT_EQ(twice, 8.0);
  const Colour red{"red"};
  ports.input("sonar", kindOf<Colour>())->set(&red);
  EXPECT_EQ(listener.colour->name, "red");
}

TEST(Ports, AreFoundByNameAndKindTogether) {
  Listener listener;
  Ports ports;
  ports.takes<Echo>("sonar", "echoes", &listener);
  ports.makes<Echo>("louder", listener.louder);
  EXPECT_NE(ports.input("sonar", kindOf<Echo>()), nullptr);
  EXPECT_EQ(ports.input("sonar", kindOf<Colour>()), nullptr);
  EXPECT_EQ(ports.input("louder", kindOf<Echo>()), nullptr) << "it is an output";
  EXPECT_NE(ports.output("louder", kindOf<Echo>()), nullptr);
  EXPECT_EQ(ports.output("sonar", kindOf<Echo>()), nullptr);
}

TEST(Ports, AnOutputIsWhatWasMadeOrNothing) {
  Listener listener;
  Colour always{"red"};
  Ports ports;
  ports.makes<Echo>("louder", listener.louder);
  ports.makes<Colour>("paint", [&] { return &always; });
  const auto* output = ports.output("louder", kindOf<Echo>());
  EXPECT_EQ(output->get(), nullptr);
  listener.louder = Echo{at(2), 0, 3.0};
  EXPECT_EQ(output->get(), &*listener.louder);
  listener.louder.reset();
  EXPECT_EQ(output->get(), nullptr);
  EXPECT_EQ(ports.output("paint", kindOf<Colour>())->get(), &always);
}

TEST(Ports, TakeOverAnInputOfAnotherComponent) {
  Listener listener;
  Ports inner, outer;
  inner.takes<Echo>("sonar", "echoes", &listener).optional();
  auto& mine = outer.add(inner.inputs().front());
  EXPECT_EQ(mine.name, "sonar");
  EXPECT_FALSE(mine.is_mandatory);
  int times = 0;
  mine.set = [&](const void*) { ++times; };
  const Echo echo;
  outer.input("sonar", kindOf<Echo>())->set(&echo);
  EXPECT_EQ(times, 1);
  EXPECT_EQ(listener.heard, 0.0) << "it does not reach the other one by itself";
}

}  // namespace
}  // namespace slam::test
