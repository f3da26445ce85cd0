#ifndef auxfem_tests_support_sampled_motion_h
#define auxfem_tests_support_sampled_motion_h

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace auxfem
{
  namespace testing_support
  {
    /** A file with a table of a function of time, gone with the object. */
    class SampledMotion
    {
    public:
      /** A row every @p spacing (s) to @p end. */
      template <class Function>
      SampledMotion(const Function &function,
                    const double    spacing,
                    const double    end)
        : file(std::filesystem::temp_directory_path() /
               ("auxfem-motion-" + std::to_string(getpid()) + ".csv"))
      {
        std::ofstream out(file);
        out.precision(17);
        for (unsigned int i = 0; i * spacing < end + spacing / 2; ++i)
          out << i * spacing << ", " << function(i * spacing) << '\n';
      }

      SampledMotion(const SampledMotion &)            = delete;
      SampledMotion &operator=(const SampledMotion &) = delete;

      ~SampledMotion()
      {
        std::filesystem::remove(file);
      }

      /** Its absolute path. */
      std::string name() const
      {
        return file.string();
      }

    private:
      const std::filesystem::path file;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
