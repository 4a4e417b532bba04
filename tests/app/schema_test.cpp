// `lustro schema`.
#include <gmock/gmock.h>

#include "app/run_command.hpp"

namespace {

using namespace lustro::testing;
using ::testing::HasSubstr;

class SchemaCommand : public CommandTest {};

TEST_F(SchemaCommand, IsJsonOfItsDraft) {
  const Outcome outcome = lustro({"schema"});
  ASSERT_EQ(outcome.code, 0);
  const auto json = outcome.json();
  EXPECT_THAT(json["$schema"].get<std::string>(), HasSubstr("2020-12"));
  EXPECT_TRUE(json["properties"].contains("objects"));
}

}  // namespace
