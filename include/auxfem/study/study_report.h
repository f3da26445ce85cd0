#ifndef auxfem_study_study_report_h
#define auxfem_study_study_report_h

#include <auxfem/output/csv_table.h>
#include <auxfem/output/verdict.h>
#include <auxfem/scene/study_definition.h>
#include <auxfem/study/measured_run.h>
#include <auxfem/study/settings.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** A table of texts. */
  struct TextTable
  {
    std::vector<std::string>              header;
    std::vector<std::vector<std::string>> rows;

    /**
     * Markdown table with aligned columns, also readable on a screen; ends with
     * a line break.
     */
    std::string markdown() const;
  };

  /** A number with three digits, e.g. `1.23e-04`; `-` for none. */
  std::string error_text(const std::optional<double> &error);

  /** A number with @p digits behind the point; `-` for none. */
  std::string decimal_text(const std::optional<double> &number,
                           unsigned int                 digits);

  /** Processor time with three digits. */
  std::string seconds_text(double seconds);

  /** @p text up to its first line break. */
  std::string first_line(const std::string &text);

  /** Percentage, e.g. `7 %` for 0.07; `-` for none. */
  std::string percent_text(const std::optional<double> &part);

  /** A number with twelve digits; empty for none. */
  std::string number_text(const std::optional<double> &number);

  /** @name Columns of study.csv that several studies have, and their cells. */
  ///@{
  std::vector<Column>      columns_of_settings(const Scene &scene);
  std::vector<std::string> cells_of(const Settings &settings,
                                    const Scene    &scene);
  std::vector<Column>      columns_of_run();
  std::vector<std::string> cells_of(const MeasuredRun &run);
  ///@}

  /** Style of a line, by numbers from 0 on. */
  struct LineStyle
  {
    /** Colour of a method, see colour_of_order() and colour_of_scheme(). */
    unsigned int colour = 0;
    /** Dash pattern that distinguishes lines of one method. */
    unsigned int dashes = 0;
    unsigned int marks  = 0;
  };

  /** @name Colours of methods, the same in all pictures of all studies. */
  ///@{
  unsigned int colour_of_order(unsigned int order);
  unsigned int colour_of_scheme(const std::string &scheme);
  ///@}

  /** One line of a picture. */
  struct Curve
  {
    std::string                            title;
    std::vector<std::pair<double, double>> points; ///< positive
    LineStyle                              style = {};
    /** Whether the curve is wide and pale, beneath others. */
    bool is_beneath = false;
  };

  /** A picture with logarithmic axes. */
  struct LogPicture
  {
    std::string        name; ///< of the files, without ending
    std::string        title, x_label, y_label;
    std::vector<Curve> curves;
    /** Whether integer slopes of curves are marked. */
    bool marks_slopes = false;
  };

  /** Results of a study. */
  struct StudyReport
  {
    /** Markdown text for the screen and for study.md. */
    std::string text;
    /** Columns and rows of study.csv, with full precision. */
    std::vector<Column>                   columns;
    std::vector<std::vector<std::string>> rows;
    std::vector<LogPicture>               pictures;
    std::vector<Finding>                  findings;
  };

  /** Finding on a quantity that the reference does not resolve. */
  Finding unresolved_finding(const QuantityDefinition &quantity);

  /** Adds @p finding unless an equal one exists. */
  void add_finding(const Finding &finding, std::vector<Finding> &findings);

  /**
   * Cheapest of @p runs; among those of equal cost within the timing noise, the
   * one with the smallest error. Empty without runs.
   */
  template <class Run, class Price, class Error>
  std::optional<Run> cheapest_of(const std::vector<Run> &runs,
                                 const Price            &price,
                                 const Error            &error)
  {
    constexpr double noise = 1.2, instant = 0.01; // s
    const auto       is_cheaper = [&price](const Run &one, const Run &other) {
      return price(one) < price(other);
    };
    const auto cheapest =
      std::min_element(runs.begin(), runs.end(), is_cheaper);
    std::optional<Run> best;
    for (const Run &run : runs)
      if (price(run) <= noise * price(*cheapest) + instant &&
          (!best || error(run) < error(*best)))
        best = run;
    return best;
  }

  /**
   * Adds a finding on a reference, named @p what, that failed or is unreliable.
   */
  void add_finding_on_reference(const MeasuredRun    &reference,
                                const std::string    &what,
                                std::vector<Finding> &findings);

  /**
   * Gnuplot script with data that draws @p picture to NAME.svg and NAME.png.
   */
  std::string gnuplot_script(const LogPicture &picture);

  /** Files that draw_picture() writes for a picture of that name. */
  std::vector<std::string> picture_files(const std::string &name);

  /**
   * Writes NAME.gnuplot to @p folder and runs gnuplot. Returns false if gnuplot
   * is missing or fails. Throws ComputationError if the script cannot be
   * written.
   */
  bool draw_picture(const LogPicture &picture, const std::string &folder);
} // namespace auxfem

#endif
