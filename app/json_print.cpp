// A JSON result on stdout: see json_out.hpp.
#include "json_out.hpp"
#include "report.hpp"

namespace lustro::app {

Result<void> print_json(const Json& json) {
  return print(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace lustro::app
