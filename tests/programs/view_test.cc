#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;
  namespace fs = std::filesystem;

  /** A run of a short scene, and auxfem-view on it. */
  class ViewProgram : public ProgramTest
  {
  protected:
    ViewProgram()
    {
      write("scene.prm", data_text("star.prm"));
      EXPECT_EQ(run_auxfem({"scene.prm",
                            "--output",
                            "out",
                            "--set",
                            "Time/End time=0.4 ms",
                            "--set",
                            "Output/Graphics interval=0.1 ms"})
                  .exit_code,
                0);
    }

    ProgramRun view(const Words &words) const
    {
      Words all = {AUXFEM_PYTHON,
                   std::string(AUXFEM_PRM_DIRECTORY) +
                     "/../scripts/auxfem-view"};
      all.insert(all.end(), words.begin(), words.end());
      return run_program(all);
    }

    /** The size of a picture, how many of its pixels are not white, and how
     * many frames it has, by Pillow. */
    std::vector<double> measure(const std::string &picture) const
    {
      const ProgramRun run =
        run_program({AUXFEM_PYTHON,
                     "-c",
                     "import sys\n"
                     "from PIL import Image\n"
                     "image = Image.open(sys.argv[1])\n"
                     "n = getattr(image, 'n_frames', 1)\n"
                     "drawn = image.convert('L').point(lambda v: v < 250)\n"
                     "print(*image.size, drawn.histogram()[1], n)\n",
                     picture});
      EXPECT_EQ(run.exit_code, 0) << run.errors;
      std::istringstream  stream(run.output);
      std::vector<double> numbers(4);
      for (double &number : numbers)
        stream >> number;
      return numbers;
    }
  };

  TEST_F(ViewProgram, DrawsPicturesCurvesAndFilms)
  {
    const ProgramRun picture =
      view({"picture", "out", "0", "0.0004", "-o", "a.png", "--width", "600"});
    ASSERT_EQ(picture.exit_code, 0) << picture.errors;
    const auto size = measure(path("a.png"));
    EXPECT_EQ(size[0], 600);
    EXPECT_GT(size[2], 2000);
    ASSERT_EQ(view({"curves", "out", "-o", "b.png"}).exit_code, 0);
    EXPECT_GT(measure(path("b.png"))[2], 2000);
    const ProgramRun film =
      view({"film", "out", "-o", "c.gif", "--width", "300"});
    ASSERT_EQ(film.exit_code, 0) << film.errors;
    // The start, and four times 0.1 ms.
    EXPECT_EQ(measure(path("c.gif"))[3], 5);
    ASSERT_EQ(view({"series", "out", "-o", "d", "--width", "300"}).exit_code,
              0);
    EXPECT_TRUE(fs::exists(path("d/00004.png")));
    EXPECT_FALSE(fs::exists(path("d/00005.png")));
  }

  TEST_F(ViewProgram, SaysWhatIsWrong)
  {
    const auto expect_message = [&](const Words       &words,
                                    const std::string &message) {
      const ProgramRun run = view(words);
      EXPECT_EQ(run.exit_code, 1) << message;
      expect_contains(run.errors + run.output, {message});
    };
    expect_message({"picture", "nowhere"}, "there is no folder nowhere");
    expect_message({"picture", "out", "--color", "beauty"},
                   "there is no field beauty; there are");
    expect_message({"curves", "out", "beauty"}, "has no column beauty; it has");
    expect_message({"curves", "out", "--table", "crush"}, "there is no table");
    expect_message({"film", "out", "-o", "film.avi"}, "films are .gif or .mp4");
    expect_message({"modes", "out"}, "has no such mode; it has none");
  }
} // namespace
