// `lustro lab [SCENE]`: the page on which light is seen and touched, served on this machine for this machine.
#include <fmt/format.h>

#include "app/browser.hpp"
#include "app/commands.hpp"
#include "app/json_out.hpp"
#include "app/lab_server.hpp"
#include "app/scene_input.hpp"

namespace lustro::app {
namespace {

struct LabFlags {
  std::string scene;
  std::optional<int> port;
  std::string page;
  bool no_open = false;
};

Result<void> announce(const Session& session, const LabFlags& flags, const LabWatch* watch, int port) {
  const std::string url = fmt::format("http://127.0.0.1:{}/", port);
  const Json entry = watch == nullptr ? Json(nullptr) : Json(watch->model().entry);
  const Json line{{"url", url}, {"port", port}, {"entry", entry}};
  const Result<void> printed =
      print(session.json ? line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" : fmt::format("lustro lab: {}\n", url));
  if (printed && !flags.no_open && has_display()) {
    open_browser(url);
  }
  return printed;
}

Result<ExitCode> run_lab(const Session& session, const LabFlags& flags) {
  if (flags.port && (*flags.port < 0 || *flags.port > 65535)) {
    return fail(ErrorKind::usage, "--port", fmt::format("{} is outside 0..65535", *flags.port));
  }
  if (const Result<void> can = check_server(); !can) {
    return tl::unexpected(can.error());
  }
  const Result<LabPage> page = lab_page(flags.page, embedded_page());
  if (!page) {
    return tl::unexpected(page.error());
  }
  std::optional<LabWatch> watch;
  if (!flags.scene.empty()) {
    LoadOptions options;
    options.threads = session.threads;
    Result<LabWatch> begun = LabWatch::begin(flags.scene, options);
    if (!begun) {
      return tl::unexpected(begun.error());
    }
    say_warnings(session, begun->model().notes);
    watch.emplace(*std::move(begun));
  }
  LabWatch* const watched = watch ? &*watch : nullptr;
  const auto started = [&](int port) { return announce(session, flags, watched, port); };
  return serve_lab(*page, watched, flags.port, started).map([] { return ExitCode::success; });
}

}  // namespace

Command make_lab(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "lab", "Opens the lab in the browser: see, touch and question the light of a scene");
  auto flags = std::make_shared<LabFlags>();
  app->add_option("SCENE", flags->scene,
                  fmt::format("{}; the page follows its files as they change (default: the page's own example)", kSceneHelp))
      ->type_name("FILE");
  const std::string server = "Server";
  app->add_option("--port", flags->port, "The port on loopback, 0..65535; 0 is any (default: the first free one from 8000 on)")
      ->type_name("N")
      ->group(server);
  app->add_flag("--no-open", flags->no_open, "Prints the address, and opens no browser")->disable_flag_override()->group(server);
  app->add_option("--page", flags->page, "Serves the built page of this folder, not the one inside the program: for who works on it")
      ->type_name("FOLDER")
      ->group(server);
  return {app,
          {{"lustro lab", "opens the lab with an example; Ctrl-C ends it"},
           {"lustro lab bunny.obj", "shows the model, and shows it anew whenever it is saved"},
           {"lustro lab scene.json --port 8080 --no-open", "for a browser that is opened by hand, or through a tunnel"}},
          [&session, flags] { return run_lab(session, *flags); }};
}

}  // namespace lustro::app
