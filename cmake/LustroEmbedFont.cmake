# DejaVu Sans, which labels are drawn with, becomes a byte array of the library. It is taken from the system at build time (Debian:
# fonts-dejavu-core), so that no copy of it lies in the repository.
find_file(LUSTRO_FONT DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/dejavu /usr/share/fonts/TTF /usr/local/share/fonts
          PATH_SUFFIXES truetype/dejavu dejavu DOC "DejaVu Sans" NO_CMAKE_FIND_ROOT_PATH)
if(NOT LUSTRO_FONT)
  message(FATAL_ERROR "DejaVuSans.ttf is not found (Debian: fonts-dejavu-core); state it with -D LUSTRO_FONT=FILE")
endif()
lustro_embed_bytes(lustro ${LUSTRO_FONT} image/dejavu_sans.inc)
