#ifndef auxfem_output_figure_files_h
#define auxfem_output_figure_files_h

#include <auxfem/equations/equations.h>
#include <auxfem/figures/run_figures.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/scene.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** Files with figures that a run of @p scene may write. */
  std::vector<std::string> figure_files(const Scene &scene);

  /** Those of any scene. */
  std::vector<std::string> all_figure_files();

  /** Names of plates, supports and probes of @p scene, each once. */
  std::vector<std::string> names_of_bodies(const Scene &scene);

  /** Bodies and lattice of the crush curve in the scene of @p equations.
   * Collective. */
  CrushGeometry crush_geometry(const Equations &equations);

  /**
   * Writes evaluation.csv with a row for each body and axis, and if the scene
   * asks for them crush.csv and transmission.csv, each with its reference
   * `*.units.csv`, to @p folder. Throws ComputationError if writing fails.
   */
  void write_figures(const RunFigures  &figures,
                     const Scene       &scene,
                     const std::string &folder);

  /** The member `evaluation` of summary.json; null without figures. */
  Json json_of(const RunFigures &figures);

  /** Table of the figures for the screen, and remarks; empty without any. */
  std::string text_of(const RunFigures &figures);
} // namespace auxfem

#endif
