#include <springfit/core/error.h>
#include <springfit/exports/numpy.h>
#include <springfit/springs/by_table.h>

#include <minizip/zip.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace springfit
{
  namespace
  {
    /** A zip file of arrays, under a temporary name until it is whole. */
    class Archive
    {
    public:
      explicit Archive(const std::filesystem::path &path)
        : path_(path)
        , part_(path.string() + ".part")
        , zip_(zipOpen64(part_.c_str(), APPEND_STATUS_CREATE))
      {
        check(zip_ != nullptr);
      }

      ~Archive()
      {
        if (zip_)
          {
            zipClose(zip_, nullptr);
            std::error_code ignored;
            std::filesystem::remove(part_, ignored);
          }
      }

      Archive(const Archive &) = delete;
      Archive &
      operator=(const Archive &) = delete;

      void
      add(const std::string &name,
          const std::vector<std::int64_t> &numbers,
          const std::size_t width)
      {
        add(name, "<i8", numbers, width);
      }

      void
      add(const std::string &name,
          const std::vector<double> &numbers,
          const std::size_t width)
      {
        add(name, "<f8", numbers, width);
      }

      void
      add(const std::string &name, const Eigen::Matrix3Xd &field)
      {
        add(name,
            std::vector<double>(field.data(), field.data() + field.size()),
            3);
      }

      void
      add(const std::string &name, const std::string &text)
      {
        // Four bytes a letter.
        const std::u32string letters(text.begin(), text.end());
        add(name,
            "<U" + std::to_string(text.size()),
            "",
            letters.data(),
            letters.size() * sizeof(char32_t));
      }

      void
      finish()
      {
        const int status = zipClose(zip_, nullptr);
        zip_             = nullptr;
        check(status == ZIP_OK);
        std::error_code error;
        std::filesystem::rename(part_, path_, error);
        check(!error);
      }

    private:
      void
      check(const bool is_well) const
      {
        if (!is_well)
          throw RunError("The file '" + path_.string() +
                           "' could not be written.",
                         "Free space on the disk, or write elsewhere.");
      }

      template <typename Number>
      void
      add(const std::string &name,
          const std::string &type,
          const std::vector<Number> &numbers,
          const std::size_t width)
      {
        std::string shape = std::to_string(numbers.size() / width) + ",";
        if (width > 1)
          shape += ' ' + std::to_string(width);
        add(name, type, shape, numbers.data(), numbers.size() * sizeof(Number));
      }

      /** The format of an array, version 1.0 (numpy.lib.format). */
      void
      add(const std::string &name,
          const std::string &type,
          const std::string &shape,
          const void *bytes,
          const std::size_t n_bytes)
      {
        std::string head = "{'descr': '" + type +
                           "', 'fortran_order': False, 'shape': (" + shape +
                           "), }";
        constexpr std::size_t before = 10, alignment = 64;
        head.resize((before + head.size() + alignment) / alignment * alignment -
                      before,
                    ' ');
        head.back()            = '\n';
        const std::string size = {char(head.size() % 256),
                                  char(head.size() / 256)};

        // Without a date: the same results are the same files.
        const zip_fileinfo info = {};
        check(zipOpenNewFileInZip64(zip_,
                                    (name + ".npy").c_str(),
                                    &info,
                                    nullptr,
                                    0,
                                    nullptr,
                                    0,
                                    nullptr,
                                    0,
                                    0,
                                    1) == ZIP_OK);
        write("\x93NUMPY\x01" + std::string(1, '\0') + size + head);
        write(static_cast<const char *>(bytes), n_bytes);
        check(zipCloseFileInZip(zip_) == ZIP_OK);
      }

      void
      write(const std::string &text)
      {
        write(text.data(), text.size());
      }

      void
      write(const char *bytes, std::size_t size)
      {
        constexpr std::size_t at_once = 1 << 28;
        while (size > 0)
          {
            const std::size_t now = std::min(size, at_once);
            check(zipWriteInFileInZip(zip_, bytes, now) == ZIP_OK);
            bytes += now;
            size -= now;
          }
      }

      const std::filesystem::path path_, part_;
      zipFile zip_;
    };
  } // namespace

  void
  write_numpy(const std::filesystem::path &folder, const ExportedScene &scene)
  {
    Archive archive(folder / (scene.name + ".npz"));
    archive.add("nodes", scene.nodes);
    archive.add("mass", scene.mass, 1);
    std::vector<std::int64_t> held;
    for (const auto &components : scene.held)
      held.insert(held.end(), components.begin(), components.end());
    archive.add("held", held, 3);
    archive.add("support", scene.support);
    archive.add("forces", scene.forces);
    if (scene.motion)
      archive.add("motion",
                  std::vector<double>{scene.motion->step,
                                      scene.motion->duration,
                                      scene.motion->mass_damping,
                                      scene.motion->stiffness_damping,
                                      scene.motion->spring_damper},
                  1);
    for (const auto &family : by_table(scene.families))
      {
        const auto &kind  = *family.kind;
        const auto &nodes = family.members.nodes;
        archive.add(kind.word() + "_law", kind.law());
        archive.add(kind.word() + "_nodes",
                    std::vector<std::int64_t>(nodes.begin(), nodes.end()),
                    kind.n_nodes());
        for (std::size_t c = 0; c < kind.columns().size(); ++c)
          archive.add(kind.word() + '_' + kind.columns()[c].name,
                      family.members.columns[c],
                      kind.columns()[c].width);
      }
    archive.finish();
  }
} // namespace springfit
