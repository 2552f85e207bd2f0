// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rviz/config.h>
#include <rviz/panel.h>
#include <rviz/properties/property.h>
#include <rviz/tool.h>
#include <slam_msgs/Consistency.h>
#include <slam_msgs/LandmarkMap.h>
#include <std_srvs/Trigger.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <pluginlib/class_loader.hpp>
#include <string>

// The panel as rviz loads it, beside a simulated robot and ekf_wheel.

namespace {

class SlamPanelTest : public testing::Test {
 protected:
  SlamPanelTest()
      : loader_("rviz", "rviz::Panel"),
        panel_(loader_.createUnmanagedInstance("slam_rviz_plugins/SlamPanel")) {}

  /// The map that a test has loaded is an older one, in which the robot is not recognised at once.
  void SetUp() override {
    ASSERT_TRUE(ros::service::waitForService("reset", ros::Duration(30.0)));
    std_srvs::Trigger reset;
    ASSERT_TRUE(ros::service::call("reset", reset));
  }

  template <class Widget>
  Widget& find(const char* name) const {
    auto* widget = panel_->findChild<Widget*>(name);
    if (widget == nullptr) throw std::logic_error(std::string("no widget ") + name);
    return *widget;
  }
  std::string text(const char* label) const { return find<QLabel>(label).text().toStdString(); }

  /// Works as rviz does until something has come true.
  bool comesTrue(const std::function<bool()>& is_true, int seconds = 30) const {
    QElapsedTimer timer;
    timer.start();
    while (!is_true()) {
      if (timer.elapsed() > 1000 * seconds) return false;
      ros::spinOnce();
      QApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    return true;
  }

  bool shows(const char* label, const std::string& words, int seconds = 30) const {
    return comesTrue([&] { return text(label).find(words) != std::string::npos; }, seconds);
  }

  void connectTo(const char* name_space) const {
    rviz::Config config;
    config.mapSetValue("Namespace", name_space);
    panel_->load(config);
  }

  pluginlib::ClassLoader<rviz::Panel> loader_;
  std::unique_ptr<rviz::Panel> panel_;
};

TEST_F(SlamPanelTest, ShowsTheStateOfTheProduct) {
  EXPECT_TRUE(shows("trust", "confident")) << text("trust");
  EXPECT_TRUE(shows("pose", "heading")) << text("pose");
  EXPECT_TRUE(shows("product", "ekf · wheel")) << text("product");
}

TEST_F(SlamPanelTest, CallsTheServices) {
  ASSERT_TRUE(shows("trust", "confident"));
  find<QPushButton>("pause").click();
  EXPECT_TRUE(shows("answer", "Pause: observations are ignored")) << text("answer");
  EXPECT_EQ(find<QPushButton>("pause").text(), "Go on");
  find<QPushButton>("pause").click();
  EXPECT_TRUE(shows("answer", "Go on: observations are used again")) << text("answer");
  find<QLineEdit>("path").setText("panel.yaml");
  find<QPushButton>("save").click();
  EXPECT_TRUE(shows("answer", "Save: ")) << text("answer");
  EXPECT_TRUE(shows("answer", "panel.yaml")) << text("answer");
  find<QPushButton>("load").click();
  EXPECT_TRUE(shows("answer", "Load: ")) << text("answer");
  find<QLineEdit>("path").setText("no/such/map.yaml");
  find<QPushButton>("load").click();
  EXPECT_TRUE(shows("answer", "no/such/map.yaml")) << text("answer");
}

TEST_F(SlamPanelTest, AsksBeforeItForgetsTheMap) {
  ASSERT_TRUE(shows("trust", "confident"));
  for (const auto choice : {QMessageBox::No, QMessageBox::Yes}) {
    QTimer::singleShot(200, [choice] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(question, nullptr);
      question->button(choice)->click();
    });
    find<QPushButton>("reset").click();
    EXPECT_EQ(shows("answer", "Reset: ", 2), choice == QMessageBox::Yes) << text("answer");
  }
}

TEST_F(SlamPanelTest, KeepsItsNamespaceAndSaysThatNoProductRunsThere) {
  connectTo("elsewhere");
  EXPECT_TRUE(shows("trust", "no product runs here")) << text("trust");
  EXPECT_TRUE(shows("product", "no product is running"));
  find<QPushButton>("relocalise").click();
  EXPECT_TRUE(shows("answer", "no product")) << text("answer");
  rviz::Config saved;
  panel_->save(saved);
  QString name_space;
  EXPECT_TRUE(saved.mapGetString("Namespace", &name_space));
  EXPECT_EQ(name_space, "elsewhere");
}

TEST_F(SlamPanelTest, SaysThatANamespaceIsNoNameAndCallsNothingOfTheOneBefore) {
  ASSERT_TRUE(shows("trust", "confident"));
  connectTo("my robot");
  EXPECT_TRUE(shows("answer", "this namespace cannot be used", 2)) << text("answer");
  find<QPushButton>("pause").click();
  EXPECT_TRUE(shows("answer", "Pause: this namespace", 2)) << text("answer");
  EXPECT_FALSE(shows("trust", "confident", 1));
  EXPECT_TRUE(shows("product", "no product is running", 2));
  connectTo("");
  EXPECT_TRUE(shows("trust", "confident")) << text("trust");
}

TEST_F(SlamPanelTest, SaysThatTrustAndCovarianceAreUnknown) {
  connectTo("topological");
  ros::NodeHandle handle("topological");
  auto trust = handle.advertise<slam_msgs::Consistency>("consistency", 1);
  auto pose = handle.advertise<geometry_msgs::PoseWithCovarianceStamped>("pose", 1);
  ASSERT_TRUE(
      comesTrue([&] { return trust.getNumSubscribers() > 0 && pose.getNumSubscribers() > 0; }));
  slam_msgs::Consistency unknown;
  unknown.trust = "unknown";
  trust.publish(unknown);
  pose.publish(geometry_msgs::PoseWithCovarianceStamped());
  EXPECT_TRUE(shows("trust", "unknown")) << text("trust");
  EXPECT_TRUE(shows("pose", "σ unknown")) << text("pose");
}

TEST_F(SlamPanelTest, TakesAProductThatReplacesAnotherForRunning) {
  connectTo("replaced");
  ros::NodeHandle handle("replaced");
  const auto pause = [this] { return find<QPushButton>("pause").text(); };
  auto product = handle.advertise<slam_msgs::Consistency>("consistency", 1);
  ASSERT_TRUE(comesTrue([&] { return product.getNumSubscribers() > 0; }));
  find<QPushButton>("pause").click();
  EXPECT_FALSE(comesTrue([&] { return pause() == "Pause"; }, 1));
  product.shutdown();
  EXPECT_FALSE(comesTrue([&] { return pause() == "Pause"; }, 2));
  product = handle.advertise<slam_msgs::Consistency>("consistency", 1);
  EXPECT_TRUE(comesTrue([&] { return pause() == "Pause"; }));
}

class LandmarkToolTest : public testing::Test {
 protected:
  LandmarkToolTest()
      : loader_("rviz", "rviz::Tool"),
        tool_(loader_.createUnmanagedInstance("slam_rviz_plugins/LandmarkTool")) {}

  rviz::Property& topic() const { return *tool_->getPropertyContainer()->subProp("Topic"); }

  pluginlib::ClassLoader<rviz::Tool> loader_;
  std::unique_ptr<rviz::Tool> tool_;
};

TEST_F(LandmarkToolTest, IsFoundByRvizAndTakesItsTopic) {
  EXPECT_EQ(topic().getValue().toString(), "landmarks");
}

TEST_F(LandmarkToolTest, TakesAnyTopicAndListensToNoneWhileItIsNotChosen) {
  ros::NodeHandle handle;
  const auto publisher = handle.advertise<slam_msgs::LandmarkMap>("others/landmarks", 1);
  for (const char* name : {"my topic", "", "~landmarks", "others/landmarks"})
    EXPECT_NO_THROW(topic().setValue(name)) << name;
  ros::WallDuration(1.0).sleep();
  EXPECT_EQ(publisher.getNumSubscribers(), 0u);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "slam_rviz_plugins_panel_test");
  testing::InitGoogleTest(&argc, argv);
  const ros::NodeHandle handle;
  QApplication application(argc, argv);
  const int code = RUN_ALL_TESTS();
  if (argc > 1) std::filesystem::remove_all(argv[1]);  // the maps that were saved
  return code;
}
