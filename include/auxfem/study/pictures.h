#ifndef auxfem_study_pictures_h
#define auxfem_study_pictures_h

#include <auxfem/study/study_report.h>

#include <string>

namespace auxfem
{
  /** The script for gnuplot, with its data, that draws @p picture into NAME.svg
   * and NAME.png. */
  std::string gnuplot_script(const LogPicture &picture);

  /** The files that draw() leaves for a picture of that name. */
  std::vector<std::string> picture_files(const std::string &name);

  /**
   * Leaves NAME.gnuplot in @p folder and has gnuplot draw it. Returns whether
   * that worked; it does not where gnuplot is not installed. Throws
   * ComputationError if the script cannot be written.
   */
  bool draw(const LogPicture &picture, const std::string &folder);
} // namespace auxfem

#endif
