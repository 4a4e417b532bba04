# cmake -D FOLDER=... -D OUTPUT=... -D HEADER=... -P embed_page.cmake: the files of a built page as a table in C++, the definition of
# lustro::app::embedded_page(). Each file is packed by gzip, once; what does not become smaller stays as it is. An empty FOLDER makes an empty table.
set(rows "")
set(arrays "")
if(FOLDER)
  file(GLOB_RECURSE names LIST_DIRECTORIES false RELATIVE ${FOLDER} ${FOLDER}/*)
  list(FILTER names EXCLUDE REGEX "(^|/)\\.") # what is hidden is none of the page's
  list(SORT names)                            # by bytes, as the table is looked up
  set(count 0)
  foreach(name IN LISTS names)
    set(file ${FOLDER}/${name})
    file(SIZE ${file} plain)
    if(plain EQUAL 0)
      message(FATAL_ERROR "${file} is empty, which no file of a page is")
    endif()
    file(SHA256 ${file} hash)
    string(SUBSTRING ${hash} 0 32 hash)
    file(ARCHIVE_CREATE OUTPUT ${OUTPUT}.gz PATHS ${file} FORMAT raw COMPRESSION GZip COMPRESSION_LEVEL 9)
    file(SIZE ${OUTPUT}.gz packed)
    math(EXPR enough "${plain} * 95 / 100")
    if(packed LESS enough)
      file(READ ${OUTPUT}.gz bytes HEX)
      string(REGEX REPLACE "^1f8b0800........" "1f8b080000000000" bytes "${bytes}") # no time: equal pages give equal programs
      set(is_gzip true)
    else()
      file(READ ${file} bytes HEX)
      set(is_gzip false)
    endif()
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
    string(REPEAT "....." 32 line)
    string(REGEX REPLACE "(${line})" "\\1\n" bytes "${bytes}")
    string(APPEND arrays "constexpr unsigned char kFile${count}[] = {\n${bytes}\n};\n")
    string(APPEND rows "    {\"${name}\", \"\\\"${hash}\\\"\", kFile${count}, sizeof(kFile${count}), ${is_gzip}, ${plain}},\n")
    math(EXPR count "${count} + 1")
  endforeach()
  file(REMOVE ${OUTPUT}.gz)
  if(count EQUAL 0)
    set(FOLDER "")
  endif()
endif()
set(table "{}")
if(FOLDER)
  set(table "kFiles")
  string(APPEND arrays "constexpr lustro::app::EmbeddedFile kFiles[] = {\n${rows}};\n")
endif()
file(WRITE ${OUTPUT} "// Made by cmake/embed_page.cmake.
#include \"${HEADER}\"

namespace {
${arrays}}  // namespace

std::span<const lustro::app::EmbeddedFile> lustro::app::embedded_page() {
  return ${table};
}
")
