# Files of assets/ and src/ that the library carries inside itself, so that it needs no data folder at run time.
