#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <set>

#include "tools/gnomon/row_key.hpp"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

class SceneDigest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("gnomon_digest_" + std::to_string(getpid()));
        fs::create_directories(folder_ / "models");
        write("level.lua", "local c = require \"crowd\"\nreturn { file = 'models/box.gltf' }");
        write("crowd.lua", "-- it's here\nreturn { model = \"statue\" }");
        write("models/box.gltf", R"({"uri": "box.bin"})");
        write("models/box.bin", "123");
        write("models/other.bin", "456");
    }
    void TearDown() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::trunc) << text;
    }
    [[nodiscard]] std::string digest() const {
        const auto found = scene_digest(folder_ / "level.lua");
        return found ? *found : "";
    }

    fs::path folder_;
};

TEST_F(SceneDigest, ChangesWithEveryFileThatTheSceneIsMadeOf) {
    std::set<std::string> seen = {digest()};
    EXPECT_EQ(digest(), *seen.begin());
    for (const char* part : {"level.lua", "crowd.lua", "models/box.gltf", "models/box.bin"}) {
        SCOPED_TRACE(part);
        std::ofstream(folder_ / part, std::ios::app) << ' ';

        EXPECT_TRUE(seen.insert(digest()).second);
    }
}

TEST_F(SceneDigest, DoesNotChangeWithOtherFilesNorWithTime) {
    const std::string before = digest();
    write("models/other.bin", "789");
    fs::last_write_time(folder_ / "level.lua", fs::file_time_type::clock::now());

    EXPECT_EQ(digest(), before);
}

TEST_F(SceneDigest, NeedsAFile) {
    EXPECT_FALSE(scene_digest(folder_ / "nothing.lua"));
}

class RowKey : public SceneDigest {
protected:
    [[nodiscard]] std::string key(const std::string& protocol = "still") const {
        Level level;
        level.file = folder_ / "level.lua";
        level.name = "level";
        const auto common = level_key(level, camera_, options_, renderer_);
        EXPECT_TRUE(common);
        return row_key(*common, options_, light_, technique_, protocol).dump();
    }

    scene::CameraView camera_;
    MeasureOptions options_;
    std::string renderer_ = "llvmpipe";
    std::string light_ = "sun";
    std::string technique_ = "map";
};

TEST_F(RowKey, ChangesWithEverythingThatARowDependsOn) {
    std::set<std::string> seen = {key(), key("walk")};
    EXPECT_EQ(seen.size(), 2U);
    const auto expect_new = [&](const char* what) {
        EXPECT_TRUE(seen.insert(key()).second) << what;
    };
    camera_.width = 640;
    expect_new("size");
    camera_.position.x += 0.001;
    expect_new("place of the camera");
    camera_.fov_y = 1.0F;
    expect_new("angle of the camera");
    options_.truth_samples = 17;
    expect_new("samples");
    options_.timing.frames = 9;
    expect_new("timed frames");
    renderer_ = "another";
    expect_new("renderer");
    light_ = "lamp";
    expect_new("light");
    technique_ = "map@512";
    expect_new("technique");
    write("models/box.bin", "124");
    expect_new("scene");
}

TEST_F(RowKey, OfAStillDoesNotDependOnSequencesNorTheirsOnTimes) {
    const std::string still = key("still");
    const std::string walk = key("walk");
    options_.moving_frames = 5;
    EXPECT_EQ(key("still"), still);
    EXPECT_NE(key("walk"), walk);

    options_.moving_frames = MeasureOptions{}.moving_frames;
    options_.timing.frames = 9;
    EXPECT_EQ(key("walk"), walk);
    EXPECT_NE(key("still"), still);
}

} // namespace
} // namespace gnomon
