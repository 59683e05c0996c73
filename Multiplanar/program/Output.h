// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_OUTPUT_H
#define MULTIPLANAR_PROGRAM_OUTPUT_H

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

/// A file or a folder that appears whole or not at all: everything is written to a hidden neighbour of it, which takes
/// its name at the end. What stood there before stays until then. Without commit(), nothing is left behind.
class Output
{
public:
  enum class Kind
  {
    file,
    folder
  };

  /// Makes the hidden neighbour, and the folders above it where they are missing.
  /// \throws Failure if something stands there that must not be replaced, or the place cannot be written to
  Output(Kind kind, const std::string& path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Writes a file of the folder (`name` relative to it, folders in it are made), or the file itself (`name` empty).
  /// \throws Failure (exit_resource) if it cannot be written whole
  void write(const std::string& name, const std::function<void(std::ostream&)>& write_to);

  /// A file beside the output, named like it but for its extension; it appears together with the output.
  void write_beside(const std::string& extension, const std::function<void(std::ostream&)>& write_to);

  /// Puts the output in its place. \throws Failure
  void commit();

  const std::string& path() const { return target; }
  /// Where it stands until commit().
  const std::string& temporary_path() const { return temporary; }

private:
  void refuse_strangers() const;
  void make_temporary();
  void make_parents();
  void discard();
  void commit_beside();

  Kind kind;
  std::string target, temporary;
  std::string beside, beside_content;    ///< the file of write_beside(), or empty
  std::vector<std::string> made_parents; ///< innermost last
  bool committed = false;
};

#endif // MULTIPLANAR_PROGRAM_OUTPUT_H
