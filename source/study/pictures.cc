#include <auxfem/output/run_folder.h>
#include <auxfem/study/pictures.h>
#include <auxfem/study/settings.h>

#include <array>
#include <cstdlib>

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

    std::string plot_command(const LogPicture &picture)
    {
      std::string text;
      for (std::size_t i = 0; i < picture.curves.size(); ++i)
        text += (i == 0 ? "plot " : ", \\\n     ") +
          ("$curve" + std::to_string(i)) + " using 1:2 with linespoints " +
          (picture.curves[i].is_beneath ? "linewidth 8 linecolor 'gray80'"
                                        : "linewidth 2") +
          " title " + quoted(picture.curves[i].title);
      return text + '\n';
    }
  } // namespace



  std::string gnuplot_script(const LogPicture &picture)
  {
    std::string text = "# gnuplot " + picture.name + ".gnuplot\n" +
      data_blocks(picture) +
      "set logscale xy\n"
      "set format '%.0e'\n"
      "set grid\n"
      "set key below noenhanced\n"
      "set title " +
      quoted(picture.title) +
      " noenhanced\n"
      "set xlabel " +
      quoted(picture.x_label) +
      " noenhanced\n"
      "set ylabel " +
      quoted(picture.y_label) + " noenhanced\n";
    const std::array<std::pair<std::string, std::string>, 2> terminals = {
      {{"svg size 800,600", ".svg"}, {"png size 1200,900", ".png"}}};
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
