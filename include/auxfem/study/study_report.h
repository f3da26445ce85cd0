#ifndef auxfem_study_study_report_h
#define auxfem_study_study_report_h

#include <auxfem/output/csv_table.h>
#include <auxfem/output/verdict.h>
#include <auxfem/study/measured_run.h>
#include <auxfem/study/settings.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** A table for people. */
  struct TextTable
  {
    std::vector<std::string>              header;
    std::vector<std::vector<std::string>> rows;

    /**
     * As a table of Markdown whose columns are aligned, so that it serves on a
     * screen as well; ends with a line break.
     */
    std::string markdown() const;
  };

  /** A number with three digits, e.g. `1.23e-04`; `-` for none. */
  std::string error_text(const std::optional<double> &error);

  /** A number with @p digits behind the point; `-` for none. */
  std::string decimal_text(const std::optional<double> &number,
                           unsigned int                 digits);

  /** E.g. `7 %` for 0.07; `-` for none. */
  std::string percent_text(const std::optional<double> &part);

  /** A number with twelve digits; empty for none. */
  std::string number_text(const std::optional<double> &number);

  /** @name Columns of study.csv that several studies have, and their cells. */
  ///@{
  std::vector<Column>      columns_of_settings();
  std::vector<std::string> cells_of(const Settings &settings);
  std::vector<Column>      columns_of_run();
  std::vector<std::string> cells_of(const MeasuredRun &run);
  ///@}

  /** One line of a picture. */
  struct Curve
  {
    std::string                            title;
    std::vector<std::pair<double, double>> points; ///< positive
    /** Points only, without a line through them. */
    bool is_scattered = false;
  };

  /** A picture with logarithmic axes. */
  struct LogPicture
  {
    std::string        name; ///< of the files, without ending
    std::string        title, x_label, y_label;
    std::vector<Curve> curves;
  };

  /** What a study has found. */
  struct StudyReport
  {
    /** In Markdown, for the screen and for study.md. */
    std::string text;
    /** study.csv: words, and numbers with all digits. */
    std::vector<Column>                   columns;
    std::vector<std::vector<std::string>> rows;
    std::vector<LogPicture>               pictures;
    std::vector<Finding>                  findings;
  };

  /** Adds what is to be said of a reference, @p what, that failed or cannot be
   * relied on. */
  void add_finding_on_reference(const MeasuredRun    &reference,
                                const std::string    &what,
                                std::vector<Finding> &findings);
} // namespace auxfem

#endif
