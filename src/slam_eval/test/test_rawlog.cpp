// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationRange.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include "import_error.hpp"
#include "rawlog_log.hpp"
#include "rawlog_maker.hpp"
#include "second.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

class Rawlog : public testing::Test {
 protected:
  template <class Fill>
  RawlogLog read(Fill fill) {
    {
      RawlogMaker maker(path());
      fill(maker);
    }
    return readRawlog(path(), progress_);
  }

  std::string path() const { return folder_.file("a.rawlog"); }

  TempFolder folder_;
  std::ostringstream log_;
  Progress progress_{log_, false};
};

TEST_F(Rawlog, StampsAnActionLikeTheFrameBehindItAndComposesThem) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.frame(100.0);
    maker.action(1.0, 0.0, M_PI / 2.0);
    maker.frame(101.0);
    maker.action(2.0, 0.0, 0.0);
    maker.frame(102.5);
  });
  ASSERT_EQ(log.odometry.size(), 3u);
  EXPECT_EQ(log.odometry[1].stamp, 101 * kSecond);
  EXPECT_NEAR(log.odometry[1].x, 1.0, 1e-12);
  EXPECT_NEAR(log.odometry[1].theta, M_PI / 2.0, 1e-12);
  EXPECT_EQ(log.odometry[2].stamp, 102 * kSecond + kSecond / 2);
  EXPECT_NEAR(log.odometry[2].x, 1.0, 1e-12);
  EXPECT_NEAR(log.odometry[2].y, 2.0, 1e-12);
}

TEST_F(Rawlog, StartsWithTheFirstFrameWhereNoActionComesBeforeIt) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.frame(100.0);
    maker.action(1.0, 0.0, 0.0);
    maker.frame(101.0);
  });
  ASSERT_EQ(log.odometry.size(), 2u);
  EXPECT_EQ(log.odometry[0].stamp, 100 * kSecond);
  EXPECT_EQ(log.odometry[0].x, 0.0);
  EXPECT_EQ(log.sightings[0].stamp, 100 * kSecond);
}

TEST_F(Rawlog, StartsAtTheOriginWhereAnActionComesFirst) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.action(1.0, 0.0, 0.0);
    maker.frame(101.0);
  });
  ASSERT_EQ(log.odometry.size(), 2u);
  EXPECT_EQ(log.odometry[0].stamp, 101 * kSecond - RawlogLog::kStepTime);
  EXPECT_EQ(log.odometry[0].x, 0.0);
  EXPECT_NEAR(log.odometry[1].x, 1.0, 1e-12);
}

TEST_F(Rawlog, LeavesOutAnActionBehindTheLastFrame) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.action(1.0, 0.0, 0.0);
    maker.frame(101.0);
    maker.action(1.0, 0.0, 0.0);
  });
  EXPECT_EQ(log.odometry.size(), 2u);
  EXPECT_EQ(log.left_out_odometry, 1u);
}

TEST_F(Rawlog, MakesUpStampsWhereTheyAreMissingEqualOrTooClose) {
  for (const double step : {-1.0, 0.0, 1e-4}) {
    const RawlogLog log = read([step](RawlogMaker& maker) {
      for (int i = 0; i < 3; ++i) {
        maker.action(1.0, 0.0, 0.0);
        maker.frame(step < 0.0 ? 0.0 : 100.0 + i * step);
      }
    });
    EXPECT_TRUE(log.made_up_stamps);
    ASSERT_EQ(log.sightings.size(), 3u);
    EXPECT_EQ(log.odometry[0].stamp, kSecond);
    EXPECT_EQ(log.sightings[0].stamp, kSecond + kSecond / 10);
    EXPECT_EQ(log.sightings[2].stamp, kSecond + 3 * kSecond / 10);
    EXPECT_EQ(log.odometry[3].stamp, log.sightings[2].stamp);
  }
}

TEST_F(Rawlog, KeepsUsableStampsExactly) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.action(1.0, 0.0, 0.0);
    maker.frame(1571493463.25);
    maker.frame(1571493463.5);
  });
  EXPECT_FALSE(log.made_up_stamps);
  EXPECT_EQ(log.sightings[0].stamp, 1571493463250000000);
}

TEST_F(Rawlog, TakesTheCovarianceOfTheSensor) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.action(0.0, 0.0, 0.0);
    maker.frame(100.0, 2.0f, 0.5f, 3);
  });
  const RawlogLog::Reading& reading = log.sightings[0].readings[0];
  EXPECT_EQ(reading.id, 3);
  EXPECT_DOUBLE_EQ(reading.range, 2.0);
  EXPECT_NEAR(reading.bearing, 0.5, 1e-7);
  EXPECT_NEAR(reading.covariance[0], 0.01, 1e-8);
  EXPECT_NEAR(reading.covariance[3], 0.0004, 1e-9);
}

TEST_F(Rawlog, TakesTheCovarianceOfTheReadingWhereItHasOne) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.action(0.0, 0.0, 0.0);
    auto observation = RawlogMaker::bearingRange(100.0);
    observation.validCovariances = true;
    observation.sensedData[0].covariance.setDiagonal(3, 0.25);
    observation.sensedData[0].covariance(0, 1) = observation.sensedData[0].covariance(1, 0) = 0.125;
    maker.frame(observation);
  });
  EXPECT_NEAR(log.sightings[0].readings[0].covariance[0], 0.25, 1e-9);
  EXPECT_NEAR(log.sightings[0].readings[0].covariance[1], 0.125, 1e-9);
}

TEST_F(Rawlog, MarksTheCovarianceUnknownWhereTheSensorGivesNone) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.action(0.0, 0.0, 0.0);
    auto observation = RawlogMaker::bearingRange(100.0);
    observation.sensor_std_range = 0.0f;
    maker.frame(observation);
  });
  EXPECT_EQ(log.sightings[0].readings[0].covariance[0], -1.0);
}

TEST_F(Rawlog, ProjectsPitchAndSensorPoseIntoThePlane) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.action(0.0, 0.0, 0.0);
    auto observation = RawlogMaker::bearingRange(100.0, 2.0f, 0.0f);
    observation.sensedData[0].pitch = static_cast<float>(M_PI / 3.0);
    observation.sensorLocationOnRobot = mrpt::poses::CPose3D(0.1, 0.2, 0.3, 0.4, 0.0, 0.0);
    observation.sensorLabel = "camera";
    maker.frame(observation);
  });
  const RawlogLog::Sighting& sighting = log.sightings[0];
  EXPECT_EQ(sighting.sensor, "camera");
  EXPECT_NEAR(sighting.x, 0.1, 1e-6);
  EXPECT_NEAR(sighting.y, 0.2, 1e-6);
  EXPECT_NEAR(sighting.theta, 0.4, 1e-6);
  EXPECT_NEAR(sighting.readings[0].range, 1.0, 1e-6);
}

TEST_F(Rawlog, MarksUnidentifiedLandmarksAndLeavesOutImpossibleReadings) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.action(0.0, 0.0, 0.0);
    maker.frame(100.0, 2.0f, 0.5f, -1);
    maker.frame(101.0, -2.0f, 0.5f, 3);
    maker.frame(102.0, std::numeric_limits<float>::quiet_NaN(), 0.5f, 3);
  });
  EXPECT_EQ(log.sightings[0].readings[0].id, -1);
  EXPECT_EQ(log.left_out_readings, 2u);
  ASSERT_EQ(log.sightings.size(), 3u);
  EXPECT_TRUE(log.sightings[2].readings.empty());
}

TEST_F(Rawlog, ReadsSingleObservationsWithTheirOwnStampsSorted) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.odometry(100.0, 5.0, 1.0, 0.0);
    maker.odometry(101.0, 6.0, 1.0, 0.0);
    maker.observation(RawlogMaker::bearingRange(100.5));
    maker.observation(RawlogMaker::bearingRange(101.5));
    maker.odometry(102.0, 7.0, 1.0, 0.0);
  });
  EXPECT_FALSE(log.made_up_stamps);
  EXPECT_EQ(log.out_of_order, 1u);
  ASSERT_EQ(log.odometry.size(), 3u);
  EXPECT_EQ(log.odometry[0].stamp, 100 * kSecond);
  EXPECT_DOUBLE_EQ(log.odometry[2].x, 7.0);
  ASSERT_EQ(log.sightings.size(), 2u);
  EXPECT_EQ(log.sightings[1].stamp, 101 * kSecond + kSecond / 2);
}

TEST_F(Rawlog, GivesSingleObservationsWithoutTimeTheOdometryThatPrecedesThem) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.odometry(0.0, 5.0, 0.0, 0.0);
    maker.observation(RawlogMaker::bearingRange(0.0));
    maker.odometry(0.0, 6.0, 0.0, 0.0);
    maker.observation(RawlogMaker::bearingRange(0.0));
  });
  EXPECT_TRUE(log.made_up_stamps);
  ASSERT_EQ(log.odometry.size(), 3u);
  EXPECT_DOUBLE_EQ(log.odometry[0].x, 5.0);
  EXPECT_EQ(log.odometry[2].stamp, log.sightings[1].stamp);
  EXPECT_DOUBLE_EQ(log.odometry[2].x, 6.0);
}

TEST_F(Rawlog, SeparatesTwoSensorsOfOneTime) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.odometry(99.0, 0.0, 0.0, 0.0);
    maker.observation(RawlogMaker::bearingRange(100.0));
    maker.observation(RawlogMaker::bearingRange(100.0));
    maker.observation(RawlogMaker::bearingRange(101.0));
    maker.odometry(102.0, 0.0, 0.0, 0.0);
  });
  EXPECT_EQ(log.sightings[1].stamp, log.sightings[0].stamp + 1);
}

TEST_F(Rawlog, CountsObservationsOfOtherSensors) {
  const RawlogLog log = read([](RawlogMaker& maker) {
    maker.odometry(99.0, 0.0, 0.0, 0.0);
    maker.observation(mrpt::obs::CObservationRange());
  });
  EXPECT_EQ(log.other_objects, 1u);
  EXPECT_TRUE(log.sightings.empty());
}

TEST_F(Rawlog, RefusesALogWithoutOdometryOrWithMotionInSpace) {
  const auto without =
      messageOf<ImportError>([this] { read([](RawlogMaker& maker) { maker.frame(100.0); }); });
  EXPECT_NE(without.find("holds no planar odometry"), std::string::npos) << without;
  const auto in_space = messageOf<ImportError>([this] {
    read([](RawlogMaker& maker) {
      mrpt::obs::CActionCollection actions;
      actions.insert(mrpt::obs::CActionRobotMovement3D());
      maker.observation(RawlogMaker::bearingRange(1.0));
      maker.object(actions);
    });
  });
  EXPECT_NE(in_space.find("only planar logs"), std::string::npos) << in_space;
}

TEST_F(Rawlog, RefusesAFileThatIsNoRawlogOrIsNotThere) {
  folder_.write("a.rawlog", "this is a text, and no rawlog at all\n");
  const auto message = messageOf<ImportError>([this] { readRawlog(path(), progress_); });
  EXPECT_NE(message.find("is no MRPT rawlog"), std::string::npos) << message;
  folder_.write("a.rawlog", "");
  EXPECT_THROW(readRawlog(path(), progress_), ImportError);
  EXPECT_THROW(readRawlog(folder_.file("none"), progress_), UsageError);
}

TEST_F(Rawlog, RefusesATruncatedFileWhereverItEnds) {
  read([](RawlogMaker& maker) {
    for (int i = 0; i < 20; ++i) {
      maker.action(1.0, 0.1 * i, 0.0);
      maker.frame(100.0 + i);
    }
  });
  const auto size = std::filesystem::file_size(path());
  for (auto kept = size - 1; kept > size / 10; kept -= size / 10) {
    std::filesystem::resize_file(path(), kept);
    const auto message = messageOf<ImportError>([this] { readRawlog(path(), progress_); });
    EXPECT_NE(message.find("truncated"), std::string::npos) << kept << ": " << message;
  }
}

}  // namespace
}  // namespace slam::eval
