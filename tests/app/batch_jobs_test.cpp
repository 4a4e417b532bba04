// Which models a batch draws, and how their pictures are called.
#include "app/batch_jobs.hpp"

#include <gmock/gmock.h>

#include "app/run_command.hpp"

namespace {

using lustro::app::batch_jobs;
using lustro::app::BatchInputs;
using lustro::testing::write_text;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class BatchJobs : public lustro::testing::CommandTest {
 protected:
  void file(const std::string& name) {
    std::filesystem::create_directories((work() / name).parent_path());
    write_text(work() / name, "");
  }
  /// `input > picture` of each job, from the work folder.
  std::vector<std::string> jobs(BatchInputs inputs) {
    for (std::string& argument : inputs.arguments) {
      argument = argument.starts_with("primitive:") ? argument : (work() / argument).string();
    }
    const auto found = batch_jobs(inputs, "out");
    std::vector<std::string> lines;
    if (!found) {
      return lines;
    }
    for (const auto& job : *found) {
      const std::string input =
          job.input.starts_with("primitive:") ? job.input : std::filesystem::path(job.input).lexically_relative(work()).string();
      lines.push_back(input + " > " + job.output.string());
    }
    return lines;
  }
};

TEST_F(BatchJobs, AFolderGivesItsMeshesInOrder) {
  for (const char* name : {"m/b.ply", "m/a.OBJ", "m/c.stl", "m/readme.txt", "m/scene.json", "m/mesh.gltf", "m/sub/d.obj"}) {
    file(name);
  }
  EXPECT_THAT(jobs({{"m"}, "", false}), ElementsAre("m/a.OBJ > out/a.png", "m/b.ply > out/b.png", "m/c.stl > out/c.png"));
  EXPECT_THAT(jobs({{"m/"}, "", true}),
              ElementsAre("m/a.OBJ > out/a.png", "m/b.ply > out/b.png", "m/c.stl > out/c.png", "m/sub/d.obj > out/sub/d.png"));
}

TEST_F(BatchJobs, ALinkToAFolderIsNotFollowed) {
  file("m/sub/d.obj");
  std::filesystem::create_directory_symlink(work() / "m", work() / "m/sub/again");
  EXPECT_THAT(jobs({{"m"}, "", true}), ElementsAre("m/sub/d.obj > out/sub/d.png"));
}

TEST_F(BatchJobs, FilesNamedAloneLieFlat) {
  EXPECT_THAT(jobs({{"x/y/a.obj", "b.json", "primitive:sphere:8", "x/y/a.obj", "x/./y/a.obj"}, "", false}),
              ElementsAre("x/y/a.obj > out/a.png", "b.json > out/b.png", "primitive:sphere:8 > out/sphere-8.png"));
}

TEST_F(BatchJobs, ClashesAreToldApartByAsManyFoldersAsItTakes) {
  EXPECT_THAT(jobs({{"x/a.obj", "y/a.obj", "y/b.obj"}, "", false}),
              ElementsAre("x/a.obj > out/x/a.png", "y/a.obj > out/y/a.png", "y/b.obj > out/b.png"));
  EXPECT_THAT(jobs({{"1/x/a.obj", "2/x/a.obj"}, "", false}), ElementsAre("1/x/a.obj > out/1/x/a.png", "2/x/a.obj > out/2/x/a.png"));
  EXPECT_THAT(jobs({{"torus.obj", "primitive:torus"}, "", false}),
              ElementsAre("torus.obj > out/work/torus.png", "primitive:torus > out/torus.png"));
}

TEST_F(BatchJobs, ModelsThatDifferInTheirExtensionKeepIt) {
  file("m/a.obj");
  file("m/a.stl");
  file("m/a.obj.obj");
  EXPECT_THAT(jobs({{"m"}, "", false}), ElementsAre("m/a.obj > out/a.obj.png", "m/a.obj.obj > out/a.obj.obj.png", "m/a.stl > out/a.stl.png"));
}

TEST_F(BatchJobs, NoPictureLeavesTheOutputFolder) {
  for (const std::string& line : jobs({{"../../../../../../../../../a.obj", "x/../../a.obj", "a.obj"}, "", false})) {
    const std::filesystem::path picture = line.substr(line.find(" > ") + 3);
    EXPECT_EQ(*picture.begin(), "out");
    EXPECT_EQ(picture.lexically_normal(), picture);
  }
}

TEST_F(BatchJobs, AListNamesOneModelALine) {
  write_text(work() / "list", "x/a.obj\r\n\nname with spaces.ply\n# no comment.stl");
  const auto found = batch_jobs({{}, (work() / "list").string(), false}, "out");
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 3U);
  EXPECT_EQ((*found)[0].input, "x/a.obj");
  EXPECT_EQ((*found)[1].output, "out/name with spaces.png");
  EXPECT_EQ((*found)[2].input, "# no comment.stl");
}

TEST_F(BatchJobs, NothingToDrawIsAnError) {
  std::filesystem::create_directories(work() / "empty");
  EXPECT_THAT(jobs({{"empty"}, "", true}), IsEmpty());
  EXPECT_EQ(batch_jobs({{}, (work() / "absent").string(), false}, "out").error().kind, lustro::ErrorKind::io);
}

}  // namespace
