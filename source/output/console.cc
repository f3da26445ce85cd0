#include <auxfem/output/console.h>
#include <auxfem/output/notes.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/overview.h>
#include <auxfem/output/summary.h>
#include <auxfem/output/verdict.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

#include <nlohmann/json.hpp>
#include <sys/ioctl.h>
#include <unistd.h>

namespace auxfem
{
  namespace
  {
    /** Wall seconds between two updates of a line on a terminal. */
    constexpr double update_interval = 0.1;

    template <typename... Arguments>
    std::string format(const char *pattern, const Arguments... arguments)
    {
      char text[200];
      std::snprintf(text, sizeof(text), pattern, arguments...);
      return text;
    }
  } // namespace

  std::string format_duration(const double seconds)
  {
    const long long total =
      std::isfinite(seconds) ? std::llround(std::max(0., seconds)) : 0;
    const long long hours = total / 3600, minutes = total / 60 % 60;
    return hours > 0 ? format("%lld:%02lld:%02lld", hours, minutes, total % 60)
                     : format("%lld:%02lld", minutes, total % 60);
  }

  std::string indented(const std::string &text)
  {
    constexpr int width = 93;
    std::string   lines;
    for (const std::string &line :
         dealii::Utilities::break_text_into_lines(text, width))
      lines += (lines.empty() ? "  " : "\n  ") + line;
    return lines;
  }

  namespace
  {
    std::string format_point(const Progress &progress)
    {
      std::string line =
        format("%5lu  load factor %.6g  arc length %.5g m  it %2u",
               progress.step,
               progress.path->load_factor,
               progress.time,
               progress.iterations);
      if (progress.retries > 0)
        line += format(" (%u rejected)", progress.retries);
      if (progress.path->n_negative)
        line += format("  negative %lu", *progress.path->n_negative);
      if (progress.relative_balance)
        line += format("  energy %+.1e", *progress.relative_balance);
      return line;
    }
  } // namespace

  std::string format_progress(const Progress &progress)
  {
    if (progress.path)
      return format_point(progress);
    const int   width = std::to_string(progress.n_steps).size();
    std::string line  = format("%*lu/%lu  t %.5g s  dt %.3g  it %2u",
                              width,
                              progress.step,
                              progress.n_steps,
                              progress.time,
                              progress.dt,
                              progress.iterations);
    if (progress.retries > 0)
      line += format(" (%u rejected)", progress.retries);
    line += format("  res %.1e", progress.relative_residual);
    if (progress.relative_balance)
      line += format("  energy %+.1e", *progress.relative_balance);

    const double fraction = progress.fraction();
    if (fraction >= 1)
      line += "  took " + format_duration(progress.seconds);
    else if (progress.time > progress.begin_time)
      line += "  left " +
        format_duration(progress.seconds * (progress.end_time - progress.time) /
                        (progress.time - progress.begin_time));
    return line;
  }

  unsigned int terminal_width(const unsigned int n_processes)
  {
    // Output of mpirun through pseudo-terminals often ends in a file.
    if (n_processes > 1 || !isatty(STDOUT_FILENO))
      return 0;
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0)
      return 80;
    return size.ws_col;
  }

  Console::Console(std::ostream      &screen,
                   const unsigned int terminal_width,
                   std::ostream      &log)
    : screen(screen)
    , log(log)
    , terminal_width(terminal_width)
  {}

  Console::~Console()
  {
    close_line();
  }

  void Console::print(const std::string &text)
  {
    close_line();
    screen << text << std::endl;
    print_to_log(text);
  }

  void Console::print_to_log(const std::string &text)
  {
    log << text << std::endl;
  }

  void Console::show(const std::string &text)
  {
    const double now = std::chrono::duration<double>(
                         std::chrono::steady_clock::now().time_since_epoch())
                         .count();
    if (terminal_width == 0 || now < last_show + update_interval)
      return;
    rewrite(text);
    last_show = now;
  }

  void Console::progress(const Progress &progress)
  {
    latest           = progress;
    latest_on_screen = false;
    latest_in_log    = false;

    // The tolerance covers round-off of summed steps.
    const int  reached = std::floor(20 * progress.fraction() + 1e-9);
    const bool milestone =
      progress.path ? progress.step % 10 == 0 : reached > last_twentieth;
    last_twentieth = std::max(last_twentieth, reached);

    const bool rewrite_due = terminal_width > 0 &&
      (line_length == 0 || progress.seconds >= last_rewrite + update_interval);
    const bool log_due = milestone || progress.retries > 0;
    if (!rewrite_due && !log_due)
      return;

    const std::string line = format_progress(progress);
    if (rewrite_due)
      {
        rewrite(line);
        last_rewrite = progress.seconds;
      }
    else if (milestone && terminal_width == 0)
      {
        screen << line << std::endl;
        latest_on_screen = true;
      }
    if (log_due)
      {
        print_to_log(line);
        latest_in_log = true;
      }
  }

  void Console::end_progress()
  {
    if (latest && !latest_on_screen)
      {
        const std::string line = format_progress(*latest);
        if (terminal_width > 0)
          rewrite(line);
        else
          screen << line << std::endl;
      }
    if (latest && !latest_in_log)
      print_to_log(format_progress(*latest));
    latest.reset();
    close_line();
  }

  void Console::rewrite(const std::string &text)
  {
    // A line that wraps could not be rewritten.
    const std::string line = text.substr(0, terminal_width - 1);
    const std::size_t rest =
      line_length > line.size() ? line_length - line.size() : 0;
    screen << '\r' << line << std::string(rest, ' ') << std::flush;
    line_length      = line.size();
    latest_on_screen = true;
  }

  void Console::close_line()
  {
    if (line_length > 0)
      screen << std::endl;
    line_length = 0;
  }

  RunReport::RunReport(const Scene          &scene,
                       const Equations      &equations,
                       const FileRules      &rules,
                       const FolderContents &further)
    : scene(scene)
    , notes(notes_on(equations))
  {
    const UnknownLayout &layout = equations.unknowns().layout;
    const Counts         counts = count(equations);
    size                        = counts.mass_and_size;
    on_first_rank(layout.communicator(), [&]() {
      files.emplace(scene, rules, further);
      console.emplace(std::cout,
                      terminal_width(layout.n_ranks()),
                      files->log());
      print(overview_text(scene,
                          counts,
                          equations.model().plan.simulated.decisions,
                          notes) +
            '\n');
    });
  }

  void RunReport::print(const std::string &text)
  {
    console->print(text);
  }

  void RunReport::claim_series(const std::vector<std::string> &names)
  {
    for (const std::string &name : names)
      files->claim_series(name);
  }

  void RunReport::finish(const Json                 &found,
                         const std::vector<Finding> &findings)
  {
    Json json = json_of_run(scene, "completed", 0);
    add_verdict(json, findings);
    json.update(json_of(size));
    json.update(found);
    if (!notes.empty())
      json["notes"] = notes;
    const std::string &folder = scene.output.directory;
    replace_file(folder + "/summary.json", json.dump(2) + '\n');
    print("  Results are in " + folder);
    print(verdict_text(findings));
  }
} // namespace auxfem
