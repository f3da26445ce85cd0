#include <auxfem/output/run_folder.h>
#include <auxfem/study/pictures.h>
#include <auxfem/study/settings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace auxfem
{
  namespace
  {
    /** @p text between quotes, in which gnuplot knows no escapes. */
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
            text += short_number(x) + " " + short_number(y) + '\n';
          text += "end_of_data\n";
        }
      return text;
    }

    /** Told apart also by who sees red and green alike (Okabe and Ito 2008). */
    constexpr std::array<const char *, 8> colours = {{"#0072B2",
                                                      "#D55E00",
                                                      "#009E73",
                                                      "#CC79A7",
                                                      "#E69F00",
                                                      "#56B4E9",
                                                      "#000000",
                                                      "#8B6914"}};

    /** Those of gnuplot from 4 on are easily told apart. */
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

    /** A part of a curve that is straight, with a slope that is a whole number.
     */
    struct Slope
    {
      int   number;
      Point from, to;
    };

    /** The last of @p curve over three points, whose slopes from one to the next
     * are alike: there curves are farthest from each other. */
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

    /** Each slope once, where the first curve has it. */
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

    /** How far down the picture a curve's mark is: a part of the range of y. */
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

    /** Lines of exactly these slopes, a little below the curves. */
    std::string slope_marks(const LogPicture &picture)
    {
      const auto place = [](const double x, const double y) {
        return "first " + short_number(x) + ", first " + short_number(y);
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
      // Room at the left, for the names of slopes.
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



  bool draw(const LogPicture &picture, const std::string &folder)
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
