#include "io/find_file.hpp"

#include "io/io_testing.hpp"
#include "io/temporary_folder.hpp"

namespace lustro {
namespace {

using testing::HasSubstr;

struct Tree : TemporaryFolder {
  Tree() {
    write("models/chair/a.png", "");
    write("models/chair/with space.png", "");
    write("models/chair/tex/B.PNG", "");
    write("models/textures/c.png", "");
    write("secret.png", "");
  }
  [[nodiscard]] std::filesystem::path folder() const { return path / "models" / "chair"; }
  [[nodiscard]] FoundFile find(const std::string& name) const { return good(find_texture(folder(), name)); }
  [[nodiscard]] std::string problem(const std::string& name) const { return bad(find_texture(folder(), name)).message; }
};

TEST(FindTexture, NamesAreRelativeToTheMtlFileWithSlashesOfEitherKind) {
  const Tree tree;
  for (const char* name : {"a.png", "./a.png", ".\\a.png", "tex/../a.png"}) {
    EXPECT_EQ(tree.find(name).path.lexically_normal(), tree.folder() / "a.png") << name;
    EXPECT_EQ(tree.find(name).note, "") << name;
  }
  EXPECT_EQ(tree.find("with space.png").path, tree.folder() / "with space.png");
  EXPECT_EQ(tree.find("tex\\B.PNG").path, tree.folder() / "tex/B.PNG");
}

TEST(FindTexture, TheFolderAroundTheModelsIsInsideAndWhatLiesBeyondIsNot) {
  const Tree tree;
  EXPECT_EQ(tree.find("../textures/c.png").path, tree.folder() / "../textures/c.png");
  EXPECT_EQ(tree.problem("../../secret.png"), "\"../../secret.png\" leads out of its folder and the one around it");
  EXPECT_EQ(tree.problem("../../nothing.png"), "\"../../nothing.png\" leads out of its folder and the one around it");
  EXPECT_EQ(tree.problem("tex/../../../secret.png"), "\"tex/../../../secret.png\" leads out of its folder and the one around it");
}

TEST(FindTexture, ALinkCountsAsWhatItPointsTo) {
  const Tree tree;
  std::filesystem::create_symlink(tree.path / "secret.png", tree.folder() / "link.png");
  std::filesystem::create_symlink(tree.folder() / "a.png", tree.folder() / "inner.png");
  std::filesystem::create_directory_symlink(tree.path, tree.folder() / "out");
  EXPECT_THAT(tree.problem("link.png"), HasSubstr("leads out"));
  EXPECT_THAT(tree.problem("LINK.png"), HasSubstr("is missing"));
  EXPECT_THAT(tree.problem("out/secret.png"), HasSubstr("leads out"));
  EXPECT_EQ(tree.find("inner.png").path, tree.folder() / "inner.png");
}

TEST(FindTexture, AnAbsoluteNameStandsForItsLastPartBesideTheMtlFile) {
  const Tree tree;
  for (const std::string& name : {std::string("C:\\Users\\x\\a.png"), std::string("/somewhere/a.png"), (tree.path / "models/a.png").string(),
                                  std::string("\\\\server\\a.png")}) {
    EXPECT_EQ(tree.find(name).path, tree.folder() / "a.png") << name;
    EXPECT_THAT(tree.find(name).note, HasSubstr("is an absolute path, which is not followed")) << name;
  }
  const std::string secret = (tree.path / "secret.png").string();
  EXPECT_EQ(tree.problem(secret), "\"" + secret + "\" is an absolute path, which is not followed");
}

TEST(FindTexture, AFolderThatDidNotComeAlongIsOverlooked) {
  const Tree tree;
  EXPECT_EQ(tree.find("maps/a.png").path, tree.folder() / "a.png");
  EXPECT_EQ(tree.find("maps/a.png").note, "\"maps/a.png\" is missing: the file of that name beside the one that names it is used");
}

TEST(FindTexture, TheCaseOfLettersIsTheLastThingOverlooked) {
  const Tree tree;
  EXPECT_EQ(tree.find("tex/b.png").path, tree.folder() / "tex/B.PNG");
  EXPECT_EQ(tree.find("tex/b.png").note, "\"tex/b.png\" is missing: \"B.PNG\", which differs in case, is used");
  EXPECT_EQ(tree.find("D:\\A.Png").path, tree.folder() / "a.png");
}

TEST(FindTexture, NothingIsNoFile) {
  const Tree tree;
  EXPECT_EQ(tree.problem("gone.png"), "\"gone.png\" is missing");
  EXPECT_EQ(tree.problem("tex"), "\"tex\" is missing");
  EXPECT_EQ(tree.problem("tex/"), "\"tex/\" names no file");
  EXPECT_EQ(bad(find_texture(tree.folder(), "..")).kind, ErrorKind::io);
}

}  // namespace
}  // namespace lustro
