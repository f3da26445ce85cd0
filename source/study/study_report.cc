#include <auxfem/output/output_folder.h>
#include <auxfem/study/settings.h>
#include <auxfem/study/study_report.h>
#include <auxfem/time/schemes/time_scheme.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>

namespace auxfem
{
  namespace
  {
    std::string padded(const std::string &text, const std::size_t width)
    {
      return std::string(width - std::min(width, text.size()), ' ') + text;
    }

    std::string
    formatted(const char *pattern, const double number, const int precision)
    {
      char text[40];
      std::snprintf(text, sizeof(text), pattern, precision, number);
      return text;
    }
  } // namespace

  std::string TextTable::markdown() const
  {
    std::vector<std::size_t> widths(header.size(), 3);
    const auto               widen = [&widths](const auto &row) {
      for (std::size_t i = 0; i < row.size(); ++i)
        widths[i] = std::max(widths[i], row[i].size());
    };
    widen(header);
    for (const auto &row : rows)
      widen(row);

    std::string text;
    const auto  add = [&text, &widths](const auto &row) {
      text += "|";
      for (std::size_t i = 0; i < row.size(); ++i)
        text += " " + padded(row[i], widths[i]) + " |";
      text += '\n';
    };
    add(header);
    text += "|";
    for (const std::size_t width : widths)
      text += " " + std::string(width - 1, '-') + ": |";
    text += '\n';
    for (const auto &row : rows)
      add(row);
    return text;
  }

  std::string error_text(const std::optional<double> &error)
  {
    return error ? formatted("%.*e", *error, 2) : "-";
  }

  std::string decimal_text(const std::optional<double> &number,
                           const unsigned int           digits)
  {
    return number ? formatted("%.*f", *number, digits) : "-";
  }

  std::string seconds_text(const double seconds)
  {
    return formatted("%.*g", seconds, 3);
  }

  std::string first_line(const std::string &text)
  {
    return text.substr(0, text.find('\n'));
  }

  std::string percent_text(const std::optional<double> &part)
  {
    // This avoids printing -0 %.
    const double whole = part ? std::round(100 * *part) : 0;
    return part ? decimal_text(whole == 0 ? 0 : whole, 0) + " %" : "-";
  }

  std::string number_text(const std::optional<double> &number)
  {
    return number ? number_text(*number) : "";
  }

  std::vector<Column> columns_of_settings(const Scene &scene)
  {
    std::vector<Column> columns;
    if (has_mesh(scene))
      columns = {{"order", "", "polynomial order of the struts' elements"},
                 {"elements", "", "elements a strut"}};
    columns.insert(columns.end(),
                   {{"time_step", "s", "time step"},
                    {"relative_tolerance", "1", "Time/Relative tolerance"},
                    {"newton_tolerance", "1", "Newton/Tolerance"},
                    {"scheme", "", "Time/Scheme"}});
    return columns;
  }

  std::vector<std::string> cells_of(const Settings &settings,
                                    const Scene    &scene)
  {
    std::vector<std::string> cells;
    if (has_mesh(scene))
      cells = {std::to_string(settings.order),
               std::to_string(settings.elements())};
    cells.insert(cells.end(),
                 {number_text(settings.time_step),
                  number_text(settings.time_tolerance),
                  number_text(settings.newton_tolerance),
                  settings.scheme});
    return cells;
  }

  std::vector<Column> columns_of_run()
  {
    return {{"unknowns", "", "free unknowns"},
            {"steps", "", "steps done"},
            {"iterations", "", "Newton iterations, or evaluations"},
            {"factorizations", "", "factorizations of the tangent"},
            {"cpu", "s", "processor time of all ranks"},
            {"wall", "s", "wall time"},
            {"memory", "byte", "peak memory of the process, or sum of ranks"},
            {"verdict", "", "how far the run can be relied on"},
            {"exit", "", "completed, or why it ended early"}};
  }

  std::vector<std::string> cells_of(const MeasuredRun &run)
  {
    return {std::to_string(run.unknowns),
            std::to_string(run.steps),
            std::to_string(run.iterations),
            std::to_string(run.factorizations),
            number_text(run.cpu_seconds),
            number_text(run.wall_seconds),
            std::to_string(run.memory),
            name_of(run.verdict),
            run.exit_state};
  }

  unsigned int colour_of_order(const unsigned int order)
  {
    return order - 1;
  }

  unsigned int colour_of_scheme(const std::string &scheme)
  {
    const auto &registry = time_scheme_registry();
    return std::find_if(registry.begin(),
                        registry.end(),
                        [&scheme](const TimeSchemeEntry &entry) {
                          return entry.name == scheme;
                        }) -
      registry.begin();
  }

  Finding unresolved_finding(const QuantityDefinition &quantity)
  {
    return {
      Verdict::doubtful,
      "The reference does not resolve the quantity \"" + quantity.name +
        "\": its error in the reference exceeds 10 %, for example because it "
        "is zero up to round-off. Recommendations ignore it. Choose other "
        "Quantities, or finer runs.",
      0,
      ""};
  }

  void add_finding(const Finding &finding, std::vector<Finding> &findings)
  {
    const bool is_there =
      std::any_of(findings.begin(), findings.end(), [&](const Finding &other) {
        return other.text == finding.text;
      });
    if (!is_there)
      findings.push_back(finding);
  }

  void add_finding_on_reference(const MeasuredRun    &reference,
                                const std::string    &what,
                                std::vector<Finding> &findings)
  {
    if (!reference.completed())
      add_finding({Verdict::not_to_be_used,
                   what + " failed, so errors are unknown: " +
                     first_line(reference.exit_state),
                   0,
                   ""},
                  findings);
    else if (reference.verdict != Verdict::sound)
      add_finding({reference.verdict,
                   what + " is itself " + name_of(reference.verdict) +
                     ". Run the scene with its settings to see why.",
                   0,
                   ""},
                  findings);
  }

  namespace
  {
    /**
     * Quotes @p text for gnuplot, which has no escapes within single quotes.
     */
    std::string quoted(const std::string &text)
    {
      std::string result = "'";
      for (const char character : text)
        result += character == '\'' ? "''" : std::string(1, character);
      return result + "'";
    }

    std::string data_blocks(const LogPicture &picture)
    {
      std::string text;
      for (std::size_t i = 0; i < picture.curves.size(); ++i)
        {
          text += "$curve" + std::to_string(i) + " << end_of_data\n";
          for (const auto &[x, y] : picture.curves[i].points)
            text += number_text(x) + " " + number_text(y) + '\n';
          text += "end_of_data\n";
        }
      return text;
    }

    /** Palette for colour-blind readers (Okabe and Ito 2008). */
    constexpr std::array<const char *, 8> colours = {{"#0072B2",
                                                      "#D55E00",
                                                      "#009E73",
                                                      "#CC79A7",
                                                      "#E69F00",
                                                      "#56B4E9",
                                                      "#000000",
                                                      "#8B6914"}};

    /** Numbers of gnuplot styles; marks from 4 on are easily distinguished. */
    constexpr unsigned int n_dashes = 5, n_marks = 10, first_mark = 4;

    std::string text_of(const LineStyle &style)
    {
      return "linewidth 2 linecolor '" +
        std::string(colours[style.colour % colours.size()]) + "' dashtype " +
        std::to_string(1 + style.dashes % n_dashes) + " pointtype " +
        std::to_string(first_mark + style.marks % n_marks);
    }

    std::string plot_command(const LogPicture &picture)
    {
      std::string text;
      for (std::size_t i = 0; i < picture.curves.size(); ++i)
        text += (i == 0 ? "plot " : ", \\\n     ") +
          ("$curve" + std::to_string(i)) + " using 1:2 with linespoints " +
          (picture.curves[i].is_beneath ? "linewidth 8 linecolor 'gray80'"
                                        : text_of(picture.curves[i].style)) +
          " title " + quoted(picture.curves[i].title);
      return text + '\n';
    }

    using Point = std::pair<double, double>;

    /** A straight part of a curve with an integer slope. */
    struct Slope
    {
      int   number;
      Point from, to;
    };

    /**
     * Last straight part of @p curve over three points, where curves are
     * farthest apart.
     */
    std::optional<Slope> slope_of(const Curve &curve)
    {
      constexpr double alike = 0.15;
      const auto      &p     = curve.points;
      const auto       slope = [&p](const std::size_t i) {
        return std::log(p[i + 1].second / p[i].second) /
          std::log(p[i + 1].first / p[i].first);
      };
      for (std::size_t i = p.size(); i-- > 2;)
        {
          const double number = std::round(slope(i - 1));
          if (number > 0 && std::abs(slope(i - 2) - number) < alike &&
              std::abs(slope(i - 1) - number) < alike)
            return Slope{int(number), p[i - 1], p[i]};
        }
      return {};
    }

    /** Distinct slopes, each at the first curve with it. */
    std::vector<Slope> slopes_in(const LogPicture &picture)
    {
      std::vector<Slope> slopes;
      for (const Curve &curve : picture.curves)
        if (const auto slope = slope_of(curve))
          if (std::none_of(slopes.begin(), slopes.end(), [&](const auto &one) {
                return one.number == slope->number;
              }))
            slopes.push_back(*slope);
      return slopes;
    }

    /** Factor by which the mark lies below its curve. */
    double factor_below(const LogPicture &picture)
    {
      double least = std::numeric_limits<double>::max(), largest = 0;
      for (const Curve &curve : picture.curves)
        for (const Point &point : curve.points)
          {
            least   = std::min(least, point.second);
            largest = std::max(largest, point.second);
          }
      return std::pow(largest / least, -0.03);
    }

    /** Commands for lines of these exact slopes below the curves. */
    std::string slope_marks(const LogPicture &picture)
    {
      const auto place = [](const double x, const double y) {
        return "first " + number_text(x) + ", first " + number_text(y);
      };
      std::string text;
      for (const Slope &slope : slopes_in(picture))
        {
          const auto [x, end] = slope.to;
          const double y      = end * factor_below(picture);
          const double ratio  = slope.from.first / x;
          text += "set arrow from " +
            place(x * ratio, y * std::pow(ratio, slope.number)) + " to " +
            place(x, y) +
            " nohead front dashtype 2 linewidth 1.5 linecolor 'gray30'\n"
            "set label 'slope " +
            std::to_string(slope.number) + "' at " + place(x, y) +
            " right front offset -0.7,0 textcolor 'gray30'\n";
        }
      return text;
    }
  } // namespace

  std::string gnuplot_script(const LogPicture &picture)
  {
    std::string text = "# gnuplot " + picture.name + ".gnuplot\n" +
      data_blocks(picture) +
      "set logscale xy\n"
      "set format '%.0e'\n"
      // The left margin has room for the names of slopes.
      "set autoscale fix\n"
      "set offsets graph 0.12, graph 0.03, graph 0.05, graph 0.05\n"
      "set grid\n"
      "set key below noenhanced font ',9'\n"
      "set title " +
      quoted(picture.title) +
      " noenhanced\n"
      "set xlabel " +
      quoted(picture.x_label) +
      " noenhanced\n"
      "set ylabel " +
      quoted(picture.y_label) + " noenhanced\n" +
      (picture.marks_slopes ? slope_marks(picture) : "");
    const std::array<std::pair<std::string, std::string>, 2> terminals = {
      {{"svg size 800,600", ".svg"},
       {"pngcairo size 1200,900 fontscale 1.4", ".png"}}};
    for (const auto &[terminal, ending] : terminals)
      text += "set terminal " + terminal + "\nset output " +
        quoted(picture.name + ending) + '\n' + plot_command(picture);
    return text;
  }

  std::vector<std::string> picture_files(const std::string &name)
  {
    return {name + ".gnuplot", name + ".svg", name + ".png"};
  }

  bool draw_picture(const LogPicture &picture, const std::string &folder)
  {
    replace_file(folder + "/" + picture.name + ".gnuplot",
                 gnuplot_script(picture));
    std::string in_quotes = "'";
    for (const char character : folder)
      in_quotes += character == '\'' ? "'\\''" : std::string(1, character);
    const std::string command = "cd " + in_quotes + "' && gnuplot '" +
      picture.name + ".gnuplot' >/dev/null 2>&1";
    return std::system(command.c_str()) == 0;
  }
} // namespace auxfem
